#include "engine/observe/frames.h"
#include "engine/observe/observer.h"
#include "engine/observe/probes.h"
#include "engine/observe/series.h"
#include "engine/observe/tally.h"
#include "engine/observe/wall_shear.h"

namespace rouleau::observe {

const std::vector<const ObserverKind*>& catalogue() {
  static const std::vector<const ObserverKind*> kinds = {
      &run_summary, &series, &probes, &frames, &wall_shear_stress,
  };
  return kinds;
}

}  // namespace rouleau::observe
