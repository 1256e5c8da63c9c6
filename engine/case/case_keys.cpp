#include "engine/case/case_keys.h"

#include <algorithm>

#include "engine/case/case.h"

namespace rouleau {
namespace {

Range above(double least, double most) {
  return {.least = least, .most = most, .above_least = true};
}

Range within(double least, double most) {
  return {.least = least, .most = most};
}

Range only(double value) {
  return {.least = value, .most = value};
}

/// Of anything in a vessel: longer than nothing and shorter than a metre.
Range length_range() {
  return {.least = 0, .most = 1, .above_least = true, .below_most = true};
}

Range interval_range() {
  return {.least = 1e-12, .most = 1000, .or_zero = true};
}

Key vessel() {
  return {.name = "vessel",
          .kind = Kind::object,
          .description = "What the blood flows through.",
          .required = true,
          .members = {
              {.name = "shape",
               .kind = Kind::choice,
               .description = "Two parallel walls.",
               .fallback = "straight",
               .choices = {"straight"}},
              {.name = "ends",
               .kind = Kind::choice,
               .description = "Plasma enters at x = 0 and leaves at x = length.",
               .fallback = "open",
               .choices = {"open"}},
              {.name = "length",
               .description = "From inlet to outlet.",
               .unit = "m",
               .range = length_range(),
               .required = true},
              {.name = "diameter",
               .description = "From the lower wall to the upper one.",
               .unit = "m",
               .range = length_range(),
               .required = true},
          }};
}

Key plasma() {
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

Key inflow() {
  return {.name = "inflow",
          .kind = Kind::object,
          .description = "How plasma enters.",
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
          }};
}

Key outflow() {
  return {.name = "outflow",
          .kind = Kind::object,
          .description = "How plasma leaves.",
          .members = {
              {.name = "pressure",
               .description = "At the outlet plane.",
               .unit = "Pa",
               .range = within(-1e6, 1e6),
               .fallback = Outflow{}.pressure[0]},
          }};
}

Key thrombi() {
  return {.name = "thrombi",
          .kind = Kind::list,
          .description = "Semicircles on the walls.",
          .most_entries = max_thrombi,
          .members = {
              {.name = "wall",
               .kind = Kind::choice,
               .description = "The wall it sits on.",
               .required = true,
               .choices = {"lower", "upper"}},
              {.name = "x",
               .description = "Of its centre, from the inlet.",
               .unit = "m",
               .range = within(0, 1),
               .required = true},
              {.name = "radius",
               .description = "Of the semicircle.",
               .unit = "m",
               .range = length_range(),
               .required = true},
          }};
}

Key cells() {
  const RedCell cell;
  return {.name = "cells",
          .kind = Kind::list,
          .description = "Red cells at the start of the run; their moduli are per unit depth.",
          .most_entries = max_cells,
          .members = {
              {.name = "x",
               .description = "Of its centre, from the inlet.",
               .unit = "m",
               .range = within(0, 1),
               .required = true},
              {.name = "y",
               .description = "Of its centre, from the lower wall.",
               .unit = "m",
               .range = within(0, 1),
               .required = true},
              {.name = "diameter",
               .description = "Of the circle that the cell is deflated from.",
               .unit = "m",
               .range = length_range(),
               .fallback = cell.diameter},
              {.name = "fill",
               .description = "Area of the cell over that of the circle; 1 keeps the circle.",
               .range = within(least_fill, 1),
               .fallback = cell.fill},
              {.name = "angle",
               .description = "Of the long axis to x, counter-clockwise.",
               .unit = "degrees",
               .range = within(-360, 360),
               .fallback = cell.angle},
              {.name = "stretch_modulus",
               .description = "E_s of the membrane, the same at every spacing.",
               .unit = "N/m",
               .range = above(0, 1),
               .fallback = cell.stretch_modulus},
              {.name = "bend_modulus",
               .description = "B of the membrane, the same at every spacing.",
               .unit = "J",
               .range = above(0, 1e-10),
               .fallback = cell.bend_modulus},
              {.name = "viscosity_ratio",
               .description = "Viscosity inside over that of the plasma.",
               .range = only(1),
               .fallback = cell.viscosity_ratio},
              {.name = "shape",
               .kind = Kind::choice,
               .description = "The shape it starts with: rest is the force-free one at its area.",
               .fallback = "rest",
               .choices = {"rest"}},
          }};
}

Key effects() {
  return {.name = "effects",
          .kind = Kind::switch_map,
          .description = "Effects by name, as the plan lists them: auto lets the scene decide.",
          .most_entries = max_effects,
          .choices = {"auto", "on", "off"}};
}

Key numerics() {
  const Numerics standard;
  return {.name = "numerics",
          .kind = Kind::object,
          .description = "How the scene is computed.",
          .members = {
              {.name = "preset",
               .kind = Kind::choice,
               .description = "Sets every knob that is not given: the spacing is 5e-7 m in draft, 4e-7 m in "
                              "standard and 2.5e-7 m in fine.",
               .fallback = "standard",
               .choices = {"draft", "standard", "fine"}},
              {.name = "spacing",
               .description = "Particle spacing d0; the preset's where it is not given.",
               .unit = "m",
               .range = above(0, 1e-2)},
              {.name = "time_step",
               .description = "Time step; auto lets the plan choose.",
               .unit = "s",
               .range = within(1e-12, 1),
               .fallback = "auto",
               .or_auto = true},
              {.name = "kernel_radius",
               .description = "Radius of the kernel in spacings.",
               .range = within(2.6, 4),
               .fallback = standard.kernel_radius},
              {.name = "pressure_tolerance",
               .description = "Relative residual at which the pressure solver stops.",
               .range = within(1e-10, 0.1),
               .fallback = standard.pressure_tolerance},
              {.name = "threads",
               .kind = Kind::integer,
               .description = "Threads that compute.",
               .range = only(1),
               .fallback = standard.threads},
          }};
}

Key output() {
  return {.name = "output",
          .kind = Kind::object,
          .description = "What the archive keeps.",
          .members = {
              {.name = "series_interval",
               .description = "Between rows of the time series; 0 for none.",
               .unit = "s",
               .range = interval_range(),
               .fallback = OutputSettings{}.series_interval},
              {.name = "frame_interval",
               .description = "Between frames of all particles; 0 for none.",
               .unit = "s",
               .range = interval_range(),
               .fallback = OutputSettings{}.frame_interval},
          }};
}

Key whole_case() {
  return {.name = "case",
          .kind = Kind::object,
          .description =
              "One scene: SI units, angles in degrees, x along the vessel from the inlet, y across it "
              "from the lower wall.",
          .members = {
              {.name = "version",
               .kind = Kind::integer,
               .description = "Of this format.",
               .range = only(1),
               .required = true},
              {.name = "name",
               .kind = Kind::text,
               .description = "What people call the case.",
               .fallback = "",
               .most_entries = max_name_length},
              vessel(),
              plasma(),
              inflow(),
              outflow(),
              thrombi(),
              cells(),
              effects(),
              numerics(),
              {.name = "duration",
               .description = "Simulated time.",
               .unit = "s",
               .range = above(0, 1000),
               .required = true},
              output(),
          }};
}

}  // namespace

bool Range::holds(double value) const {
  if (or_zero && value == 0) return true;
  return (above_least ? value > least : value >= least) && (below_most ? value < most : value <= most);
}

const Key& case_key() {
  static const Key key = whole_case();
  return key;
}

bool is_lower_snake_case(std::string_view name) {
  const auto letter = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto allowed = [letter](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; };
  return !name.empty() && letter(name.front()) && name.back() != '_' &&
         name.find("__") == std::string_view::npos && std::all_of(name.begin(), name.end(), allowed);
}

}  // namespace rouleau
