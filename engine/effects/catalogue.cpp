#include <algorithm>

#include "engine/effects/advection.h"
#include "engine/effects/aggregation.h"
#include "engine/effects/area_control.h"
#include "engine/effects/bending.h"
#include "engine/effects/body_force.h"
#include "engine/effects/contact.h"
#include "engine/effects/corner_flow.h"
#include "engine/effects/deflation.h"
#include "engine/effects/deflation_sink.h"
#include "engine/effects/density_source_relaxation.h"
#include "engine/effects/departure.h"
#include "engine/effects/direct_forces.h"
#include "engine/effects/effect.h"
#include "engine/effects/exact_projection.h"
#include "engine/effects/fading.h"
#include "engine/effects/gradient_from_least_pressure.h"
#include "engine/effects/inextensible.h"
#include "engine/effects/inflow.h"
#include "engine/effects/inflow_flux.h"
#include "engine/effects/least_squares.h"
#include "engine/effects/length_control.h"
#include "engine/effects/membrane_clearance.h"
#include "engine/effects/membrane_coupling.h"
#include "engine/effects/membrane_sides.h"
#include "engine/effects/membrane_watch.h"
#include "engine/effects/neighbours.h"
#include "engine/effects/number_density.h"
#include "engine/effects/outflow.h"
#include "engine/effects/particle_motion.h"
#include "engine/effects/periodicity.h"
#include "engine/effects/pressure_coarse_space.h"
#include "engine/effects/pressure_density.h"
#include "engine/effects/pressure_rotational.h"
#include "engine/effects/printed_bending.h"
#include "engine/effects/shifting.h"
#include "engine/effects/stretch.h"
#include "engine/effects/thin_cells.h"
#include "engine/effects/transport.h"
#include "engine/effects/velocity_correction.h"
#include "engine/effects/viscosity_contrast.h"
#include "engine/effects/viscosity_implicit.h"
#include "engine/effects/viscosity_substeps.h"
#include "engine/effects/wall_clearance.h"
#include "engine/effects/wall_end_exclusion.h"
#include "engine/effects/watch.h"
#include "engine/effects/waveform.h"

namespace rouleau::effects {

const std::vector<const EffectKind*>& catalogue() {
  // clang-format off
  static const std::vector<const EffectKind*> kinds = {
      &advection,
      &area_control,
      &length_control,
      &shifting,
      &membrane_clearance,
      &transport,
      &particle_motion,
      &wall_clearance,
      &membrane_sides,
      &waveform,
      &inflow,
      &outflow,
      &deflation,
      &periodicity,
      &departure,
      &neighbours,
      &least_squares,
      &viscosity_contrast,
      &body_force,
      &corner_flow,
      &stretch,
      &inextensible,
      &bending,
      &printed_bending,
      &contact,
      &aggregation,
      &fading,
      &membrane_coupling,
      &direct_forces,
      &viscosity_implicit,
      &viscosity_substeps,
      &deflation_sink,
      &inflow_flux,
      &pressure_rotational,
      &exact_projection,
      &number_density,
      &density_source_relaxation,
      &wall_end_exclusion,
      &pressure_coarse_space,
      &pressure_density,
      &gradient_from_least_pressure,
      &velocity_correction,
      &watch,
      &membrane_watch,
      &thin_cells,
  };
  // clang-format on
  return kinds;
}

std::string_view name_of(Stage stage) {
  switch (stage) {
    case Stage::boundaries:
      return "boundaries";
    case Stage::operators:
      return "operators";
    case Stage::forces:
      return "forces";
    case Stage::viscosity:
      return "viscosity";
    case Stage::pressure:
      return "pressure";
    case Stage::motion:
      return "motion";
    case Stage::checks:
      return "checks";
    case Stage::observers:
      break;
  }
  return "observers";
}

Need always(std::string reason) {
  return {true, std::move(reason), ""};
}

Need needs_cells(const Case& scene, std::string reason) {
  if (scene.cells.empty()) return {false, "the scene has no cells", "/cells"};
  return {true, std::move(reason), "/cells"};
}

Need needs_cells_that_leave(const Case& scene, std::string reason) {
  if (!is_open(scene.vessel)) return {false, "the vessel has no outlet", "/vessel/ends"};
  return needs_cells(scene, std::move(reason));
}

bool has_membranes(const State& state) {
  return std::any_of(state.cells.begin(), state.cells.end(),
                     [](const CellState& cell) { return !cell.departure; });
}

Need on_request(Need can, std::string reason) {
  if (!can.called_for) return can;
  return {false, std::move(reason), "/effects", true};
}

Need of_published_scheme(const Case& scene, std::string reason) {
  return of_published_scheme(scene, Need{true, std::move(reason), "/numerics/preset"});
}

Need of_published_scheme(const Case& scene, Need need) {
  if (scene.numerics.preset == Preset::paper) return need;
  return {false, "only the published scheme, preset paper, has it", "/numerics/preset"};
}

Need of_accurate_scheme(const Case& scene, Need need) {
  if (scene.numerics.preset != Preset::paper) return need;
  return {false, "the preset is the published scheme, which does without", "/numerics/preset"};
}

}  // namespace rouleau::effects
