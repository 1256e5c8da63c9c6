#pragma once

#include <string>
#include <vector>

#include "engine/simulation/run.h"

namespace rouleau::service {

/// How fast one preset computes plasma in a vessel of some size.
struct BenchPoint {
  std::string preset;
  int particles = 0;  ///< of the fluid, mean over the steps
  int steps = 0;
  double seconds = 0;               ///< of wall time
  std::vector<EffectTime> effects;  ///< the same by effect; what is left over is "rest"
};

/// Particles times steps per second.
double updates_per_second(const BenchPoint& point, double seconds);

/// Runs plasma through a straight vessel, 10 um wide and long enough for about that many particles.
/// @throws CaseError if there is no such preset or the vessel cannot be that small
BenchPoint bench(const std::string& preset, int particles, int steps);

}  // namespace rouleau::service
