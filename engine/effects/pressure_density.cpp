#include "engine/effects/pressure_density.h"

#include <cmath>

#include "engine/effects/breach.h"
#include "engine/linear/jacobi_cg.h"
#include "engine/linear/two_level_cg.h"

namespace rouleau::effects {

namespace {

constexpr int max_iterations = 3000;

class PressureDensity : public Effect {
 public:
  void apply(State& state) override {
    number(state);
    assemble(state);
    pressure_.assign(right_side_.size(), 0);
    const linear::Solve solve = solve_system(state);
    state.counters.pressure_iterations += solve.iterations;
    if (!solve.converged) throw unsolved(state, "pressure equation", solve);
    auto& p = state.particles.p;
    for (int i = 0; i < static_cast<int>(unknown_.size()); ++i) {
      if (unknown_[i] >= 0) {
        p[i] = pressure_[unknown_[i]];
      } else if (!state.projection.has_pressure[i]) {
        p[i] = 0;
      }
    }
    state.projection.base.assign(p.begin(), p.begin() + state.particles.active_end());
  }

 private:
  void number(const State& state) {
    const int rows = state.projection.neighbours.rows();
    unknown_.assign(rows, -1);
    int count = 0;
    for (int i = 0; i < rows; ++i) {
      if (state.projection.is_unknown(state.particles, i)) unknown_[i] = count++;
    }
  }

  /// Minus eq. 9.
  void assemble(const State& state) {
    const DensityProjection& projection = state.projection;
    const auto& list = projection.neighbours;
    const double scale = projection.mps.laplacian_scale();
    matrix_.clear();
    right_side_.clear();
    anchored_ = false;
    for (int i = 0; i < list.rows(); ++i) {
      if (unknown_[i] < 0) continue;
      double diagonal = 0, right = projection.source[i];
      for (int k = list.begin(i); k < list.end(i); ++k) {
        const auto a = static_cast<float>(scale * projection.weights.pair[k]);
        if (a == 0) continue;
        const int j = list.j[k];
        diagonal += a;
        if (unknown_[j] >= 0) {
          matrix_.add(unknown_[j], -a);
        } else {
          right += a * state.particles.p[j];
          anchored_ = true;
        }
      }
      matrix_.end_row(diagonal > 0 ? diagonal : 1);
      right_side_.push_back(diagonal > 0 ? right : 0);
    }
    if (!anchored_) remove_mean(right_side_);
  }

  /// Where no pressure is given it is free but for a constant, and the sources must sum to zero.
  static void remove_mean(std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    for (double& value : values) value -= sum / static_cast<double>(values.size());
  }

  linear::Solve solve_system(const State& state) {
    const double tolerance = state.scene.numerics.pressure_tolerance;
    const DensityProjection& projection = state.projection;
    if (!projection.aggregates) {
      return plain_.solve(matrix_, right_side_, pressure_, tolerance, max_iterations);
    }
    two_level_.prepare(matrix_, *projection.aggregates,
                       anchored_ ? linear::Constants::seen : linear::Constants::ignored);
    return two_level_.solve(right_side_, pressure_, tolerance, max_iterations);
  }

  std::vector<int> unknown_;  ///< [rows] its place in the system, -1: none
  bool anchored_ = false;     ///< whether pressure is given somewhere
  linear::SparseRows matrix_;
  linear::JacobiCg plain_;
  linear::TwoLevelCg two_level_;
  std::vector<double> right_side_, pressure_;
};

/// From runs. Without the coarse space a residual has to travel the whole way to the outlet.
double particles_times_iterations(const Work& work) {
  const auto wish = work.scene.effects.find("pressure_coarse_space");
  const bool coarse = wish != work.scene.effects.end() && wish->second.position == Switch::on;
  return work.particles * (coarse ? 36 : 9 * std::pow(work.along, 0.65));
}

}  // namespace

const EffectKind pressure_density{
    "pressure_density",
    Stage::pressure,
    false,
    [](const Case& scene) {
      return of_published_scheme(scene, "plasma is incompressible: eq. 9 by conjugate gradients");
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<PressureDensity>(); },
    "",
    {},
    {.particle = 760, .each = 2.9, .count = particles_times_iterations}};

}  // namespace rouleau::effects
