#include "engine/observe/frames.h"

#include <cmath>

#include "engine/observe/first_nodes.h"

namespace rouleau::observe {

namespace {

using effects::CellState;
using effects::State;

/// Appends particles in SI units, with the fields that the case asks for.
class FrameWriter {
 public:
  FrameWriter(const State& state, Frame& frame)
      : state_(state),
        frame_(frame),
        with_velocity_(carries(state.scene, Field::velocity)),
        with_pressure_(carries(state.scene, Field::pressure)) {}

  struct Particle {
    std::int64_t id;
    ParticleKind kind;
    std::int32_t cell;
    double x, y, u, v, p;
  };

  void add(const Particle& particle) {
    const Scales& s = state_.scales;
    frame_.id.push_back(particle.id);
    frame_.kind.push_back(particle.kind);
    frame_.cell.push_back(particle.cell);
    frame_.x.push_back(static_cast<float>(particle.x * s.length));
    frame_.y.push_back(static_cast<float>(particle.y * s.length));
    if (with_velocity_) frame_.u.push_back(static_cast<float>(particle.u * s.velocity));
    if (with_velocity_) frame_.v.push_back(static_cast<float>(particle.v * s.velocity));
    if (with_pressure_) frame_.p.push_back(static_cast<float>(particle.p * s.pressure()));
  }

  void add(int i, ParticleKind kind) {
    const auto& q = state_.particles;
    add({q.id[i], kind, q.cell[i], q.x[i], q.y[i], q.u[i], q.v[i], q.p[i]});
  }

  void add_membrane(const CellState& cell, std::int32_t index) {
    const FirstNodes nodes = first_nodes(state_, cell);
    for (std::size_t k = 0; k < nodes.x.size(); ++k) {
      add({cell.first_id + static_cast<std::int64_t>(k), ParticleKind::membrane, index, nodes.x[k],
           nodes.y[k], nodes.u[k], nodes.v[k], nodes.p[k]});
    }
  }

 private:
  const State& state_;
  Frame& frame_;
  bool with_velocity_, with_pressure_;
};

/// Refined plasma is shown no denser than at the start: the particles of which one in so many are drawn.
std::int64_t thinning(const State& state) {
  const double finer = state.start_spacing / state.spacing;
  return static_cast<std::int64_t>(std::ceil(finer * finer));
}

class Frames : public Observer {
 public:
  void draw(const State& state, Frame& frame) override { draw_particles(state, frame); }
};

}  // namespace

void draw_particles(const effects::State& state, Frame& frame) {
  const auto& particles = state.particles;
  frame.time = state.time * state.scales.time();
  frame.step = state.step;
  FrameWriter writer(state, frame);
  for (std::size_t c = 0; c < state.cells.size(); ++c) {
    writer.add_membrane(state.cells[c], static_cast<std::int32_t>(c));
  }
  const std::int64_t one_in = thinning(state);
  for (int i = particles.membrane_end(); i < particles.active_end(); ++i) {
    if (particles.id[i] % one_in != 0) continue;
    writer.add(i, particles.cell[i] >= 0 ? ParticleKind::inside : ParticleKind::plasma);
  }
}

const ObserverKind frames{
    "frames",
    false,
    [](const Case& scene) {
      const bool asked = scene.output.frame_interval > 0;
      return effects::Need{asked, asked ? "frames of all particles are asked for" : "no frames are asked for",
                           "/output/frame_interval"};
    },
    [](const State&, const CellFreeFlow&) -> std::unique_ptr<Observer> { return std::make_unique<Frames>(); },
    nullptr,
    {},
    {.frame = {.particle = 620}}};

}  // namespace rouleau::observe
