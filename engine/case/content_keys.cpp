#include "engine/case/case.h"
#include "engine/case/key_ranges.h"
#include "engine/case/scene_keys.h"

namespace rouleau {

Key thrombi_key() {
  return {.name = "thrombi",
          .kind = Kind::list,
          .description = "Semicircles on the walls.",
          .most_entries = max_thrombi,
          .members = {
              {.name = "wall",
               .kind = Kind::choice,
               .description = "The wall it sits on; of a bifurcation an outer one.",
               .required = true,
               .choices = {"lower", "upper"}},
              {.name = "x",
               .description =
                   "Of its centre; in a bifurcation past the trunk's end it sits on the branch's outer wall.",
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

Key cells_key() {
  const RedCell cell;
  return {.name = "cells",
          .kind = Kind::list,
          .description = "Red cells at the start of the run; their moduli are per unit depth.",
          .most_entries = max_cells,
          .members = {
              {.name = "x",
               .description = "Of its centre, from the left end.",
               .unit = "m",
               .range = within(0, 1),
               .required = true},
              {.name = "y",
               .description = "Of its centre, from the lower wall; of a bifurcation from the trunk's.",
               .unit = "m",
               .range = within(-1, 1),
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
               .range = within(1, 50),
               .fallback = cell.viscosity_ratio},
              {.name = "shape",
               .kind = Kind::choice,
               .description = "The shape it starts with: rest is the force-free one at its area, circle the "
                              "circle of its diameter, from which it deflates.",
               .fallback = "rest",
               .choices = {"rest", "circle"}},
          }};
}

}  // namespace rouleau
