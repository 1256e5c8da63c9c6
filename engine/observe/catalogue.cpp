#include "engine/observe/cell_free_layer.h"
#include "engine/observe/fahraeus.h"
#include "engine/observe/frames.h"
#include "engine/observe/hemolysis.h"
#include "engine/observe/hydraulic_resistance.h"
#include "engine/observe/membrane_maps.h"
#include "engine/observe/observer.h"
#include "engine/observe/probes.h"
#include "engine/observe/series.h"
#include "engine/observe/tally.h"
#include "engine/observe/wall_shear.h"

namespace rouleau::observe {

const std::vector<const ObserverKind*>& catalogue() {
  static const std::vector<const ObserverKind*> kinds = {
      &run_summary,          &series,          &probes,   &frames,        &wall_shear_stress,
      &hydraulic_resistance, &cell_free_layer, &fahraeus, &membrane_maps, &hemolysis,
  };
  return kinds;
}

}  // namespace rouleau::observe
