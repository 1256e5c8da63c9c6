#include "engine/effects/outflow.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>

namespace rouleau::effects {

namespace {

using geometry::Opening;
using particles::Group;
using particles::ParticleSet;

// In spacings.
constexpr int buffer_depth = 4;
constexpr double profile_depth = 3;  // of the fluid before the plane that the buffer's velocity is taken from
constexpr double profile_reach = 2;  // and how far along the plane

/// Velocity out of the vessel of one particle before the plane.
struct Sample {
  double across, weight, velocity;
};

/// One outlet: a buffer beyond the plane that carries the pressure given there, linearly on from the fluid's,
/// and the profile with which the fluid arrives at the plane. Particles cross the plane both ways.
class Outlet {
 public:
  Outlet(State& state, const Opening& opening, double pressure)
      : opening_(opening), pressure_(pressure), rows_(state.rows_across(opening.width)) {
    for (int k = 1; k <= rows_; ++k) {
      const double across = opening_.width * k / (rows_ + 1);
      for (int column = 0; column < buffer_depth; ++column)
        add(state, across, (column + 0.5) * state.spacing);
    }
  }

  void apply(State& state) {
    ParticleSet& particles = state.particles;
    cross(state);
    sample_profile(state);
    const double slope = slope_before(state);
    farthest_.assign(rows_, 0);
    for (int i = particles.membrane_end(); i < particles.inlet_end(); ++i) {
      if (particles.group[i] != Group::outlet || !here(state, i)) continue;
      const double across = opening_.across(particles.x[i], particles.y[i]);
      const double beyond = opening_.beyond(particles.x[i], particles.y[i]);
      const double velocity = velocity_at(state, across);
      particles.u[i] = velocity * opening_.ax;
      particles.v[i] = velocity * opening_.ay;
      particles.p[i] = pressure_ + slope * beyond;
      double& farthest = farthest_[row_of(across)];
      farthest = std::max(farthest, beyond);
    }
    refill(state, slope);
  }

 private:
  int add(State& state, double across, double beyond) {
    const auto [x, y] = opening_.at(across, beyond);
    const int i = state.particles.add(Group::outlet, x, y);
    state.particles.p[i] = pressure_;
    return i;
  }

  bool here(const State& state, int i) const {
    const double across = opening_.across(state.particles.x[i], state.particles.y[i]);
    const double beyond = opening_.beyond(state.particles.x[i], state.particles.y[i]);
    const double d0 = state.spacing;
    return across > -d0 && across < opening_.width + d0 && std::abs(beyond) < (buffer_depth + 2) * d0;
  }

  int row_of(double across) const {
    return std::clamp(static_cast<int>(std::lround(across / opening_.width * (rows_ + 1))) - 1, 0, rows_ - 1);
  }

  void cross(State& state) {
    ParticleSet& particles = state.particles;
    for (int i = particles.membrane_end(); i < particles.inlet_end(); ++i) {
      Group& group = particles.group[i];
      if (group != Group::fluid && group != Group::outlet) continue;
      const double beyond = opening_.beyond(particles.x[i], particles.y[i]);
      if (group == Group::fluid && beyond > 0 && here(state, i)) {
        group = Group::outlet;
      } else if (group == Group::outlet && beyond <= 0 && here(state, i)) {
        group = Group::fluid;
      } else if (group == Group::outlet && beyond > buffer_depth * state.spacing && here(state, i)) {
        group = Group::dead;
        ++state.counters.absorbed;
      }
    }
  }

  void sample_profile(const State& state) {
    const ParticleSet& particles = state.particles;
    samples_.clear();
    const double on = state.last_dt > 0 ? state.dt / state.last_dt : 0;
    for (int i = particles.membrane_end(); i < particles.active_end(); ++i) {
      if (particles.group[i] != Group::fluid) continue;
      const double before = -opening_.beyond(particles.x[i], particles.y[i]) / state.spacing;
      if (before < 0 || before > profile_depth || !here(state, i)) continue;
      samples_.push_back({opening_.across(particles.x[i], particles.y[i]), 1 - before / profile_depth,
                          (particles.u[i] + on * particles.du[i]) * opening_.ax +
                              (particles.v[i] + on * particles.dv[i]) * opening_.ay});
    }
    samples_.push_back({0, 1, 0});
    samples_.push_back({opening_.width, 1, 0});
    std::sort(samples_.begin(), samples_.end(),
              [](const Sample& a, const Sample& b) { return a.across < b.across; });
  }

  /// Of a quadratic across the plane: the profile does not change along the flow there.
  double velocity_at(const State& state, double across) const {
    const double reach = profile_reach * state.spacing;
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    auto sample = std::lower_bound(samples_.begin(), samples_.end(), across - reach,
                                   [](const Sample& s, double at) { return s.across < at; });
    for (; sample != samples_.end() && sample->across < across + reach; ++sample) {
      const double Y = (sample->across - across) / reach;
      const double w = sample->weight * (1 - Y * Y);
      const Eigen::Vector3d basis(1, Y, Y * Y);
      normal += w * basis * basis.transpose();
      right += w * sample->velocity * basis;
    }
    if (!(normal(0, 0) > 0)) return 0;
    const Eigen::LDLT<Eigen::Matrix3d> factor(normal);
    if (factor.rcond() < 1e-6) return right(0) / normal(0, 0);
    return factor.solve(right)(0);
  }

  double slope_before(const State& state) const {
    double sum = 0;
    int count = 0;
    for (int i = 0; i < static_cast<int>(state.pressure_gx.size()); ++i) {
      const double before = -opening_.beyond(state.particles.x[i], state.particles.y[i]) / state.spacing;
      if (before < 1.5 || before > 4 || !here(state, i)) continue;
      sum += state.pressure_gx[i] * opening_.ax + state.pressure_gy[i] * opening_.ay;
      ++count;
    }
    return count ? sum / count : 0;
  }

  /// Where fluid comes back, the far end of the buffer follows it.
  void refill(State& state, double slope) {
    for (int k = 0; k < rows_; ++k) {
      const double across = opening_.width * (k + 1) / (rows_ + 1);
      if (farthest_[k] > (buffer_depth - 1.5) * state.spacing) continue;
      const double velocity = velocity_at(state, across);
      if (velocity >= 0) continue;
      const double beyond = std::max(farthest_[k] + state.spacing, 0.5 * state.spacing);
      const int i = add(state, across, beyond);
      state.particles.u[i] = velocity * opening_.ax;
      state.particles.v[i] = velocity * opening_.ay;
      state.particles.p[i] = pressure_ + slope * beyond;
      ++state.counters.emitted;
    }
  }

  Opening opening_;
  double pressure_;
  int rows_;
  std::vector<Sample> samples_;
  std::vector<double> farthest_;
};

class Outflow : public Effect {
 public:
  explicit Outflow(State& state) {
    const auto& openings = state.outline.outlets();
    for (std::size_t k = 0; k < openings.size(); ++k) {
      outlets_.emplace_back(state, openings[k], state.scene.outflow.pressure[k] / state.scales.pressure());
    }
  }

  void apply(State& state) override {
    for (Outlet& outlet : outlets_) outlet.apply(state);
  }

 private:
  std::vector<Outlet> outlets_;
};

}  // namespace

const EffectKind outflow{
    "outflow",
    Stage::boundaries,
    false,
    [](const Case& scene) {
      if (!is_open(scene.vessel)) return Need{false, "the vessel has no outlet", "/vessel/ends"};
      return Need{true, "the vessel's outlet is open", "/outflow"};
    },
    [](State& state) -> std::unique_ptr<Effect> { return std::make_unique<Outflow>(state); },
    "",
    {},
    {.particle = 5.4, .each = 1500, .count = [](const Work& w) { return w.outlet_rows; }}};

}  // namespace rouleau::effects
