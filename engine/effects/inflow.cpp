#include "engine/effects/inflow.h"

#include <algorithm>
#include <cmath>

namespace rouleau::effects {

namespace {

using particles::Group;
using particles::ParticleSet;

constexpr int buffer_depth = 4;  // spacings

/// Each lane is a row of buffer particles one spacing apart that moves as a whole, in either direction. What
/// of it passes the inlet plane becomes fluid; when it recedes, fluid that passes the plane is taken away
/// and the lane is filled up from the front.
class Inflow : public Effect {
 public:
  explicit Inflow(State& state) {
    const double d0 = state.spacing;
    const double height = state.outline.height();
    const bool plug = state.scene.inflow.profile == Profile::plug;
    const double plug_velocity = starts_as_published(state.scene) ? 1 : height / (height - d0);
    for (int k = 1; k <= state.rows(); ++k) {
      const double y = state.row_y(k);
      const double velocity = plug ? plug_velocity : state.parabola(y / height);
      const Lane lane{y, velocity, velocity * state.inflow_factor, state.row_offset(k) - 0.5 * d0};
      for (int column = 0; column < buffer_depth; ++column) emit(state, lane, lane.head - column * d0);
      state.lanes.push_back(lane);
    }
  }

  void apply(State& state) override {
    const double d0 = state.spacing;
    admit(state);
    for (Lane& lane : state.lanes) {
      lane.head += lane.speed * state.dt;  // as the motion of this step has taken it
      while (lane.head > 0) {
        lane.head -= d0;
        emit(state, lane, lane.head - (buffer_depth - 1) * d0);
        ++state.counters.emitted;
      }
      while (lane.head <= -d0) {
        lane.head += d0;
        emit(state, lane, lane.head);
      }
      lane.speed = lane.velocity * state.inflow_factor;
    }
    drive(state);
  }

 private:
  static void emit(State& state, const Lane& lane, double x) {
    const int i = state.particles.add(Group::inlet, x, lane.y);
    state.particles.u[i] = lane.speed;
  }

  /// Buffer particles past the inlet plane become fluid, with the pressure that their new neighbours'
  /// gradients lead to (an average instead makes a pulse of 3 % with every column); fluid past it is taken
  /// away, and so is the far end of a receding lane.
  static void admit(State& state) {
    ParticleSet& particles = state.particles;
    for (int i = particles.membrane_end(); i < particles.inlet_end(); ++i) {
      const double x = particles.x[i];
      if (particles.group[i] == Group::inlet && x >= 0) {
        particles.p[i] = extrapolated_pressure(state, i);
        particles.group[i] = Group::fluid;
      } else if (particles.group[i] == Group::inlet && x < -(buffer_depth + 0.5) * state.spacing) {
        particles.group[i] = Group::dead;
      } else if (particles.group[i] == Group::fluid && x < 0) {
        particles.group[i] = Group::dead;
        ++state.counters.absorbed;
      }
    }
  }

  static double extrapolated_pressure(const State& state, int i) {
    const ParticleSet& particles = state.particles;
    const double reach = 2.5 * state.spacing;
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
    return weight > 0 ? pressure / weight : 0;
  }

  /// The buffer moves as its lanes do.
  static void drive(State& state) {
    ParticleSet& particles = state.particles;
    const double gap = state.outline.height() / (state.rows() + 1);
    const int last = static_cast<int>(state.lanes.size()) - 1;
    for (int i = particles.active_end(); i < particles.size(); ++i) {
      if (particles.group[i] != Group::inlet) continue;
      const int k = std::clamp(static_cast<int>(std::lround(particles.y[i] / gap)) - 1, 0, last);
      particles.u[i] = state.lanes[k].speed;
    }
  }
};

}  // namespace

const EffectKind inflow{
    "inflow",
    Stage::boundaries,
    false,
    [](const Case& scene) {
      if (!is_open(scene.vessel)) return Need{false, "the vessel has no inlet", "/vessel/ends"};
      return Need{true, "the vessel's inlet is open", "/inflow"};
    },
    [](State& state) -> std::unique_ptr<Effect> { return std::make_unique<Inflow>(state); },
    "",
    {},
    {.particle = 3.3}};

}  // namespace rouleau::effects
