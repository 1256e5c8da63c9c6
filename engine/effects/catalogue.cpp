#include "engine/effects/advection.h"
#include "engine/effects/area_control.h"
#include "engine/effects/bending.h"
#include "engine/effects/contact.h"
#include "engine/effects/effect.h"
#include "engine/effects/inflow.h"
#include "engine/effects/inflow_flux.h"
#include "engine/effects/membrane_clearance.h"
#include "engine/effects/membrane_coupling.h"
#include "engine/effects/membrane_sides.h"
#include "engine/effects/outflow.h"
#include "engine/effects/pressure_rotational.h"
#include "engine/effects/shifting.h"
#include "engine/effects/stretch.h"
#include "engine/effects/transport.h"
#include "engine/effects/viscosity_implicit.h"
#include "engine/effects/wall_clearance.h"
#include "engine/effects/watch.h"

namespace rouleau::effects {

const std::vector<const EffectKind*>& catalogue() {
  static const std::vector<const EffectKind*> kinds = {
      &inflow,
      &outflow,
      &stretch,
      &bending,
      &contact,
      &membrane_coupling,
      &viscosity_implicit,
      &area_control,
      &inflow_flux,
      &pressure_rotational,
      &advection,
      &shifting,
      &membrane_clearance,
      &transport,
      &wall_clearance,
      &membrane_sides,
      &watch,
  };
  return kinds;
}

std::string_view name_of(Stage stage) {
  switch (stage) {
    case Stage::boundaries:
      return "boundaries";
    case Stage::forces:
      return "forces";
    case Stage::viscosity:
      return "viscosity";
    case Stage::pressure:
      return "pressure";
    case Stage::motion:
      return "motion";
    case Stage::checks:
      break;
  }
  return "checks";
}

Need always(std::string reason) {
  return {true, std::move(reason), ""};
}

Need needs_cells(const Case& scene, std::string reason) {
  if (scene.cells.empty()) return {false, "the scene has no cells", "/cells"};
  return {true, std::move(reason), "/cells"};
}

}  // namespace rouleau::effects
