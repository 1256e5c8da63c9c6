#include "engine/effects/viscosity_contrast.h"

#include <algorithm>

#include "engine/effects/neighbourhood.h"

namespace rouleau::effects {

namespace {

constexpr int smoothing_passes = 2;

/// div(nu grad u) by the Laplacian's weights, each times the mean viscosity of its pair, and implicitly the
/// other half of the stress, d_k nu d_i u_k, where the viscosity has a gradient.
class ViscosityContrast : public CellEffect, public ImplicitForce {
 public:
  void apply(State& state) override {
    find_factors(state);
    // Nothing is felt farther than the smoothing and the fits reach.
    const std::vector<int>& rows = neighbourhood_.around(state, inside_, smoothing_passes + 1);
    smooth(state, rows);
    find_gradients(state, rows);
    state.operators.scale_laplacians(rows, state.viscosity_factor);
    operators_ = &state.operators;
    list_ = &state.neighbours;
    state.implicit_forces.push_back(this);
  }

  void add_response(const double* velocity, double, double* acceleration) const override {
    add_response_of(velocity, acceleration);
  }
  void add_response(const float* velocity, double, float* acceleration) const override {
    add_response_of(velocity, acceleration);
  }

 private:
  struct Slope {
    int particle;
    double x, y;  ///< of the kinematic viscosity
  };

  void find_factors(State& state) {
    const auto& particles = state.particles;
    inside_.clear();
    state.viscosity_factor.assign(particles.velocity_end(), 1);
    for (int i = 0; i < particles.active_end(); ++i) {
      if (particles.cell[i] < 0) continue;
      inside_.push_back(i);
      const int cell = particles.cell[i];
      const double ratio = 1 + state.cells[cell].presence * (state.scene.cells[cell].viscosity_ratio - 1);
      state.viscosity_factor[i] = i < particles.membrane_end() ? 0.5 * (1 + ratio) : ratio;
    }
  }

  /// A viscosity that jumps by a factor of 50 between neighbours made the velocity flicker.
  void smooth(State& state, const std::vector<int>& rows) {
    const auto& list = state.neighbours;
    std::vector<double>& factor = state.viscosity_factor;
    for (int pass = 0; pass < smoothing_passes; ++pass) {
      sharp_ = factor;
      for (const int i : rows) {
        double weight = 1, sum = sharp_[i];
        for (int k = list.begin(i); k < list.near_end(i); ++k) {
          if (list.j[k] >= state.particles.active_end()) continue;
          const double q = 1 - list.r[k] / state.near_radius;
          weight += q * q;
          sum += q * q * sharp_[list.j[k]];
        }
        factor[i] = sum / weight;
      }
    }
  }

  /// The gradient that the Laplacian's own weights see in a linear velocity: so the two halves of the stress
  /// cancel exactly in a rotation. The gradient of the fits let cells of ratio 50 spin themselves up.
  void find_gradients(const State& state, const std::vector<int>& rows) {
    slopes_.clear();
    const auto& list = state.neighbours;
    const std::vector<double>& factor = state.viscosity_factor;
    for (const int i : rows) {
      Slope slope{i, 0, 0};
      const float* weight = state.operators.laplacian(i);
      for (int k = list.begin(i); k < list.end(i); ++k) {
        const double difference =
            0.5 * state.viscosity * (factor[list.j[k]] - factor[i]) * weight[k - list.begin(i)];
        slope.x += difference * list.dx[k];
        slope.y += difference * list.dy[k];
      }
      if (slope.x != 0 || slope.y != 0) slopes_.push_back(slope);
    }
  }

  template <class Real>
  void add_response_of(const Real* velocity, Real* acceleration) const {
    for (const Slope& slope : slopes_) {
      const int i = slope.particle;
      const float *wx = operators_->dx(i), *wy = operators_->dy(i);
      double along = 0, across = 0;
      for (int k = list_->begin(i); k < list_->end(i); ++k) {
        const int j = list_->j[k];
        const double change = slope.x * static_cast<double>(velocity[2 * j] - velocity[2 * i]) +
                              slope.y * static_cast<double>(velocity[2 * j + 1] - velocity[2 * i + 1]);
        along += wx[k - list_->begin(i)] * change;
        across += wy[k - list_->begin(i)] * change;
      }
      acceleration[2 * i] += static_cast<Real>(along);
      acceleration[2 * i + 1] += static_cast<Real>(across);
    }
  }

  std::vector<int> inside_;  ///< what cells hold
  Neighbourhood neighbourhood_;
  std::vector<Slope> slopes_;
  std::vector<double> sharp_;
  const operators::LeastSquares* operators_ = nullptr;
  const particles::NeighbourList* list_ = nullptr;
};

}  // namespace

const EffectKind viscosity_contrast{
    "viscosity_contrast",
    Stage::operators,
    false,
    [](const Case& scene) {
      Need need =
          of_accurate_scheme(scene, needs_cells(scene, "the inside of a cell is not as viscous as plasma"));
      const bool differs = std::any_of(scene.cells.begin(), scene.cells.end(),
                                       [](const RedCell& cell) { return cell.viscosity_ratio != 1; });
      if (need.called_for && !differs)
        return Need{false, "cells are as viscous as plasma", "/cells/0/viscosity_ratio"};
      return need;
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<ViscosityContrast>(); },
    CellEffect::rests,
    {},
    {.membrane_node = 2600}};

}  // namespace rouleau::effects
