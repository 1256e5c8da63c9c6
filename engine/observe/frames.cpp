#include "engine/observe/frames.h"

namespace rouleau::observe {

Frame make_frame(const effects::State& state, const WallShear& wall_shear) {
  const auto& particles = state.particles;
  const Scales& s = state.scales;
  const bool with_velocity = carries(state.scene, Field::velocity);
  const bool with_pressure = carries(state.scene, Field::pressure);
  Frame frame;
  frame.time = state.time * s.time();
  frame.step = state.step;
  for (int i = 0; i < particles.active_end(); ++i) {
    frame.id.push_back(particles.id[i]);
    frame.kind.push_back(i < particles.membrane_end() ? ParticleKind::membrane
                         : particles.cell[i] >= 0     ? ParticleKind::inside
                                                      : ParticleKind::plasma);
    frame.cell.push_back(particles.cell[i]);
    frame.x.push_back(static_cast<float>(particles.x[i] * s.length));
    frame.y.push_back(static_cast<float>(particles.y[i] * s.length));
    if (with_velocity) frame.u.push_back(static_cast<float>(particles.u[i] * s.velocity));
    if (with_velocity) frame.v.push_back(static_cast<float>(particles.v[i] * s.velocity));
    if (with_pressure) frame.p.push_back(static_cast<float>(particles.p[i] * s.pressure()));
  }
  frame.wall_shear_stress = wall_shear.stress(state);
  return frame;
}

}  // namespace rouleau::observe
