#include "engine/case/presets.h"

namespace rouleau {

Numerics preset_numerics(Preset preset) {
  Numerics numerics;
  numerics.preset = preset;
  switch (preset) {
    case Preset::draft:
      numerics.spacing = 5e-7;
      break;
    case Preset::standard:
      numerics.spacing = 4e-7;
      break;
    case Preset::fine:
      numerics.spacing = 2.5e-7;
      break;
    case Preset::paper:
      numerics.spacing = 4e-7;
      numerics.time_step = 5e-7;
      numerics.kernel_radius = 2.1;
      numerics.viscosity = Viscosity::substeps;
      numerics.pressure_tolerance = 1e-6;
      break;
  }
  return numerics;
}

}  // namespace rouleau
