#include "tests/validation/flow.h"

#include <algorithm>
#include <cmath>

#include "engine/observe/fluid_segments.h"

namespace rouleau::validation {

void Flow::advance_to(double time) {
  while (!simulation_.finished() && simulation_.time() < time * (1 - 1e-9)) simulation_.step();
}

operators::Sampler Flow::sampler() const {
  const effects::State& s = state();
  const geometry::Bounds b = s.outline.bounds();
  return {s.particles, observe::sampling_reach(s), {b.x0, b.y0, b.x1, b.y1}};
}

double Flow::divergence() const {
  const effects::State& s = state();
  double most = 0;
  for (int i = 0; i < s.particles.active_end(); ++i) {
    const double ux = s.operators.velocity_gradient(i, s.particles.u.data()).x;
    const double vy = s.operators.velocity_gradient(i, s.particles.v.data()).y;
    most = std::max(most, std::abs(ux + vy));
  }
  return most * s.spacing;
}

Measurement Flow::measurement() const {
  Measurement m;
  m.simulated_time = time();
  m.steps = state().step;
  m.particles = state().particles.active_end();
  return m;
}

}  // namespace rouleau::validation
