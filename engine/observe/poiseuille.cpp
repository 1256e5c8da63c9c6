#include "engine/observe/poiseuille.h"

#include <cmath>

namespace rouleau::observe {

bool becomes_parabola(const Case& scene) {
  const Vessel& vessel = scene.vessel;
  return vessel.shape == Shape::straight && is_open(vessel) && scene.cells.empty() && scene.thrombi.empty() &&
         scene.inflow.waveform.empty() && scene.body_acceleration == std::array<double, 2>{} &&
         vessel.wall_velocity.lower == 0 && vessel.wall_velocity.upper == 0;
}

double poiseuille_deviation(const effects::State& state) {
  const auto& particles = state.particles;
  double sum = 0;
  int count = 0;
  for (int i = particles.membrane_end(); i < particles.active_end(); ++i) {
    const double along = particles.x[i] / state.outline.length();
    if (along <= 0.8 || along >= 0.95) continue;
    const double exact = state.parabola(particles.y[i] / state.outline.height());
    sum += std::abs((particles.u[i] - exact) / exact);
    ++count;
  }
  return count ? sum / count : 0;
}

}  // namespace rouleau::observe
