#include "engine/case/case.h"
#include "engine/case/key_ranges.h"
#include "engine/case/scene_keys.h"

namespace rouleau {
namespace {

Key acceleration(const char* name) {
  return {.name = name, .description = "", .unit = "m/s2", .range = within(-1e8, 1e8)};
}

}  // namespace

Key plasma_key() {
  return {.name = "plasma",
          .kind = Kind::object,
          .description = "The fluid around the cells.",
          .members = {
              {.name = "density",
               .description = "Its density.",
               .unit = "kg/m3",
               .range = above(0, 1e5),
               .fallback = Plasma{}.density},
              {.name = "kinematic_viscosity",
               .description = "Its viscosity over its density.",
               .unit = "m2/s",
               .range = within(1e-9, 1),
               .fallback = Plasma{}.kinematic_viscosity},
          }};
}

Key inflow_key() {
  return {.name = "inflow",
          .kind = Kind::object,
          .description = "How plasma enters an open vessel.",
          .members = {
              {.name = "velocity",
               .description = "Mean over the inlet.",
               .unit = "m/s",
               .range = above(0, 10),
               .fallback = Inflow{}.velocity},
              {.name = "profile",
               .kind = Kind::choice,
               .description = "A plug has the mean velocity everywhere, a parabola is the developed flow.",
               .fallback = "plug",
               .choices = {"plug", "parabolic"}},
              {.name = "waveform",
               .kind = Kind::list,
               .description = "Times and what the velocity is multiplied by then: linear between them, held "
                              "before the first and after the last. Empty: steady.",
               .fallback = nlohmann::json::array(),
               .most_entries = max_waveform_points,
               .entries = Kind::tuple,
               .members = {{.name = "time", .description = "", .unit = "s", .range = within(0, 1e5)},
                           {.name = "factor", .description = "", .range = within(-100, 100)}}},
          }};
}

Key outflow_key() {
  return {.name = "outflow",
          .kind = Kind::object,
          .description = "How plasma leaves an open vessel.",
          .members = {
              {.name = "pressure",
               .description =
                   "At the outlet; of a bifurcation at both, or a list of that at the lower and at the "
                   "upper one.",
               .unit = "Pa",
               .range = within(-1e6, 1e6),
               .fallback = Outflow{}.pressure[0],
               .or_pair = true},
          }};
}

Key body_acceleration_key() {
  return {.name = "body_acceleration",
          .kind = Kind::tuple,
          .description = "Along x and along y, on all that is in the vessel; not of an open one.",
          .fallback = nlohmann::json::array({0.0, 0.0}),
          .members = {acceleration("ax"), acceleration("ay")}};
}

Key initial_key() {
  return {
      .name = "initial",
      .kind = Kind::object,
      .description = "How the plasma moves at the start; cells are at rest.",
      .members = {
          {.name = "flow",
           .kind = Kind::choice,
           .description = "Auto: developed in an open vessel, else at rest. Developed: the parabola of the "
                          "free vessel. Taylor_green: one pair of vortices each way, in a periodic box.",
           .fallback = "auto",
           .choices = {"auto", "rest", "developed", "taylor_green"}},
          {.name = "velocity",
           .description = "The greatest of the vortices; only with taylor_green, which needs it.",
           .unit = "m/s",
           .range = above(0, 10)},
      }};
}

}  // namespace rouleau
