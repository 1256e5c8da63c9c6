#include "engine/case/run_keys.h"

#include "engine/case/case.h"
#include "engine/case/key_ranges.h"

namespace rouleau {
namespace {

Range interval_range() {
  return {.least = 1e-12, .most = 1000, .or_zero = true};
}

Key coordinate(const char* name) {
  return {.name = name, .description = "", .unit = "m", .range = within(-1, 1)};
}

}  // namespace

Key effects_key() {
  return {.name = "effects",
          .kind = Kind::switch_map,
          .description =
              "Effects by name, as the plan lists them: auto lets the scene decide. An object of "
              "numbers switches an effect on with these parameters; the plan says which it has.",
          .most_entries = max_effects,
          .choices = {"auto", "on", "off"}};
}

Key numerics_key() {
  const Numerics standard;
  return {.name = "numerics",
          .kind = Kind::object,
          .description = "How the scene is computed.",
          .members = {
              {.name = "preset",
               .kind = Kind::choice,
               .description = "Sets every knob that is not given: the spacing is 5e-7 m in draft, 4e-7 m in "
                              "standard and in paper, which is the published scheme, and 2.5e-7 m in fine.",
               .fallback = "standard",
               .choices = {"draft", "standard", "fine", "paper"}},
              {.name = "spacing",
               .description = "Particle spacing d0; the preset's where it is not given.",
               .unit = "m",
               .range = above(0, 1e-2)},
              {.name = "time_step",
               .description =
                   "Time step; auto lets the plan choose. The preset's where it is not given: 5e-7 s in "
                   "paper, else auto.",
               .unit = "s",
               .range = within(1e-12, 1),
               .or_auto = true},
              {.name = "kernel_radius",
               .description =
                   "Radius of the kernel in spacings, at least 2.6 but in paper; the preset's where it "
                   "is not given: 2.1 in paper, else 3.1.",
               .range = within(1.5, 4)},
              {.name = "viscosity",
               .kind = Kind::choice,
               .description = "How viscosity is stepped: implicit, or in paper in explicit substeps; the "
                              "preset's where it is not given.",
               .choices = {"implicit", "substeps"}},
              {.name = "substeps",
               .kind = Kind::integer,
               .description = "Of a viscous step, where it is explicit.",
               .range = within(1, 1000),
               .fallback = standard.substeps},
              {.name = "pressure_tolerance",
               .description =
                   "Relative residual at which the pressure solver stops; the preset's where it is not "
                   "given: 1e-6 in paper, else 0.01.",
               .range = within(1e-10, 0.1)},
              {.name = "threads",
               .kind = Kind::integer,
               .description = "Threads that compute.",
               .range = only(1),
               .fallback = standard.threads},
              {.name = "refine",
               .kind = Kind::choice,
               .description =
                   "What happens when a cell is squeezed thinner than two spacings: auto goes on with "
                   "a finer spacing, down to a third of the one given; off ends the run at 1.6 spacings.",
               .fallback = "auto",
               .choices = {"auto", "off"}},
          }};
}

Key output_key() {
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
              {.name = "fields",
               .kind = Kind::list,
               .description = "What frames carry beside positions.",
               .fallback = {"velocity", "pressure"},
               .most_entries = 3,
               .entries = Kind::choice,
               .distinct = true,
               .choices = {"velocity", "pressure", "wall_shear_stress"}},
          }};
}

Key probes_key() {
  return {.name = "probes",
          .kind = Kind::list,
          .description = "Lines on which velocity and pressure are sampled at every time of the series.",
          .most_entries = max_probes,
          .members = {
              {.name = "name",
               .kind = Kind::identifier,
               .description = "What the archive calls it: letters, digits, _ and -; no two alike.",
               .required = true,
               .most_entries = max_probe_name_length},
              {.name = "from",
               .kind = Kind::tuple,
               .description = "x and y of its first point.",
               .required = true,
               .members = {coordinate("x"), coordinate("y")}},
              {.name = "to",
               .kind = Kind::tuple,
               .description = "x and y of its last point; the first one where it is not given.",
               .members = {coordinate("x"), coordinate("y")}},
              {.name = "points",
               .kind = Kind::integer,
               .description = "How many, evenly spaced, both ends included.",
               .range = within(1, 1000),
               .fallback = Probe{}.points},
          }};
}

}  // namespace rouleau
