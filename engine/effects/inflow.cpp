#include "engine/effects/inflow.h"

#include <cmath>

namespace rouleau::effects {

namespace {

using particles::Group;
using particles::ParticleSet;

constexpr int buffer_depth = 4;  // spacings

struct Lane {
  double y = 0;
  double velocity = 0;
  double last_x = 0;  ///< of its particle farthest upstream
};

class Inflow : public Effect {
 public:
  explicit Inflow(State& state) {
    const double d0 = state.spacing;
    const double height = state.outline.height();
    const bool plug = state.scene.inflow.profile == Profile::plug;
    for (int k = 1; k <= state.rows(); ++k) {
      const double y = state.row_y(k);
      Lane lane{y, plug ? height / (height - d0) : state.developed_velocity(y), 0};
      for (int column = 0; column < buffer_depth; ++column) {
        lane.last_x = state.row_offset(k) - (column + 0.5) * d0;
        emit(state.particles, lane);
      }
      lanes_.push_back(lane);
    }
  }

  void apply(State& state) override {
    admit(state);
    for (Lane& lane : lanes_) {
      while (lane.last_x > -(buffer_depth - 0.5) * state.spacing) {
        lane.last_x -= state.spacing;
        emit(state.particles, lane);
        ++state.counters.emitted;
      }
      lane.last_x += lane.velocity * state.dt;  // where the motion of this step will take it
    }
  }

 private:
  static void emit(ParticleSet& particles, const Lane& lane) {
    const int i = particles.add(Group::inlet, lane.last_x, lane.y);
    particles.u[i] = lane.velocity;
  }

  /// Buffer particles past the inlet plane become fluid, with the pressure that their new neighbours'
  /// gradients lead to (an average instead makes a pulse of 3 % with every column).
  static void admit(State& state) {
    ParticleSet& particles = state.particles;
    const double reach = 2.5 * state.spacing;
    for (int i = particles.first(Group::inlet); i < particles.inlet_end(); ++i) {
      if (particles.x[i] < 0) continue;
      double weight = 0, pressure = 0;
      for (int j = particles.membrane_end(); j < particles.active_end(); ++j) {
        const double dx = particles.x[i] - particles.x[j];
        const double dy = particles.y[i] - particles.y[j];
        const double r2 = dx * dx + dy * dy;
        if (r2 >= reach * reach) continue;
        const double w = 1 - std::sqrt(r2) / reach;
        weight += w;
        pressure += w * (particles.p[j] + state.pressure_gx[j] * dx + state.pressure_gy[j] * dy);
      }
      particles.p[i] = weight > 0 ? pressure / weight : 0;
      particles.group[i] = Group::fluid;
    }
  }

  std::vector<Lane> lanes_;
};

}  // namespace

const EffectKind inflow{
    "inflow", Stage::boundaries, false,
    [](const Case&) {
      return Need{true, "the vessel's inlet is open", "/inflow"};
    },
    [](State& state) -> std::unique_ptr<Effect> { return std::make_unique<Inflow>(state); }};

}  // namespace rouleau::effects
