#include "engine/case/case.h"
#include "engine/case/key_ranges.h"
#include "engine/case/scene_keys.h"

namespace rouleau {
namespace {

Key size(const char* name, const char* description) {
  return {.name = name, .description = description, .unit = "m", .range = length_range(), .required = true};
}

Key wall_speed(const char* wall, const char* axis) {
  return {.name = wall,
          .description = "Of the " + std::string(wall) + " wall along " + axis + ".",
          .unit = "m/s",
          .range = within(-10, 10),
          .fallback = 0.0};
}

Variant straight() {
  return {
      .choice = "straight",
      .members = {
          size("length", "From one end to the other."),
          size("diameter", "From the lower wall to the upper one."),
          {.name = "ends",
           .kind = Kind::choice,
           .description = "Open: plasma enters at x = 0 and leaves at x = length. Periodic: what leaves at "
                          "one end enters at the other.",
           .fallback = "open",
           .choices = {"open", "periodic"}},
          {.name = "wall_velocity",
           .kind = Kind::object,
           .description = "How fast the walls move; only with periodic ends.",
           .members = {wall_speed("lower", "x"), wall_speed("upper", "x")}},
      }};
}

Variant bifurcation() {
  return {
      .choice = "bifurcation",
      .members = {
          {.name = "trunk",
           .kind = Kind::object,
           .description = "What the inlet leads into, along x.",
           .required = true,
           .members = {size("length", "From the inlet to where the outer walls turn."),
                       size("diameter", "From its lower wall to its upper one.")}},
          {.name = "branches",
           .kind = Kind::object,
           .description = "What the trunk parts into: both alike, or a list of the lower and the upper one.",
           .required = true,
           .or_pair = true,
           .members = {size("length", "Of its outer wall, from the trunk to the outlet."),
                       size("diameter", "From its outer wall to its inner one.")}},
          {.name = "half_angle",
           .description = "Between each branch and the trunk's axis.",
           .unit = "degrees",
           .range = within(10, 60),
           .fallback = Vessel{}.half_angle},
      }};
}

Variant box() {
  return {.choice = "box",
          .members = {
              size("width", "Along x."),
              size("height", "Along y."),
              {.name = "ends",
               .kind = Kind::choice,
               .description = "Closed: four walls. Periodic: no walls, in both directions.",
               .fallback = "closed",
               .choices = {"closed", "periodic"}},
              {.name = "wall_velocity",
               .kind = Kind::object,
               .description = "How fast the walls move along themselves; only of a closed box.",
               .members = {wall_speed("lower", "x"), wall_speed("upper", "x"), wall_speed("left", "y"),
                           wall_speed("right", "y")}},
          }};
}

}  // namespace

Key vessel_key() {
  return {.name = "vessel",
          .kind = Kind::variant,
          .description = "What the blood flows through.",
          .required = true,
          .members = {{.name = "shape",
                       .kind = Kind::choice,
                       .description = "Two parallel walls, a trunk with two branches, or a box.",
                       .fallback = "straight",
                       .choices = {"straight", "bifurcation", "box"}}},
          .variants = {straight(), bifurcation(), box()}};
}

}  // namespace rouleau
