#include "engine/effects/viscosity_contrast.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/engine/effects/prepared_state.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::effects {
namespace {

class Contrast : public testing::TestWithParam<double> {
 protected:
  static Case scene() {
    Case scene = coarse_vessel_with_cells();
    scene.cells[0].viscosity_ratio = GetParam();
    return scene;
  }

  Contrast() : state_(prepared_state(scene())), effect_(viscosity_contrast.make(state_)) {
    effect_->apply(state_);
  }

  /// The viscous force of a velocity that is linear, u = a + grad x r.
  std::vector<double> force_of(double ux, double uy, double vx, double vy) const {
    const auto& p = state_.particles;
    std::vector<double> velocity(2 * p.x.size()), laplacian, weights;
    for (int i = 0; i < p.size(); ++i) {
      velocity[2 * i] = 3 + ux * p.x[i] + uy * p.y[i];
      velocity[2 * i + 1] = -2 + vx * p.x[i] + vy * p.y[i];
    }
    state_.operators.velocity_laplacians(velocity.data(), laplacian, weights);
    std::vector<double> force(laplacian.size(), 0);
    for (const ImplicitForce* implicit : state_.implicit_forces) {
      implicit->add_response(velocity.data(), state_.dt, force.data());
    }
    for (std::size_t k = 0; k < force.size(); ++k) force[k] += state_.viscosity * laplacian[k];
    return force;
  }

  State state_;
  std::unique_ptr<Effect> effect_;
};

INSTANTIATE_TEST_SUITE_P(Ratios, Contrast, testing::Values(2.0, 50.0));

TEST_P(Contrast, TheInsideIsMoreViscousAndWhatIsFarFromTheCellIsPlasma) {
  double most = 0;
  int plasma = 0;
  for (int i = 0; i < state_.particles.active_end(); ++i) {
    most = std::max(most, state_.viscosity_factor[i]);
    plasma += state_.viscosity_factor[i] == 1;
    ASSERT_GE(state_.viscosity_factor[i], 1);
    ASSERT_LE(state_.viscosity_factor[i], GetParam());
  }
  EXPECT_GT(most, 0.7 * GetParam());
  EXPECT_GT(plasma, state_.particles.active_end() / 3);
}

TEST_P(Contrast, ARotationMeetsNoResistance) {
  const double scale = state_.viscosity * GetParam() / state_.spacing;
  for (const double f : force_of(0, 1, -1, 0)) ASSERT_NEAR(f, 0, 1e-4 * scale);
}

// div(2 nu e) = 2 e grad nu, the gradient as the Laplacian sees it in a stretching along x.
TEST_P(Contrast, TheStressIsThatOfTheSymmetricGradient) {
  const auto stretching = force_of(1, 0, 0, -1), shear = force_of(0, 1, 1, 0);
  const double scale = state_.viscosity * GetParam() / state_.spacing;
  double most = 0;
  for (int i = 0; i < state_.particles.active_end(); ++i) {
    const double nu_x = stretching[2 * i] / 2, nu_y = -stretching[2 * i + 1] / 2;
    ASSERT_NEAR(shear[2 * i], 2 * nu_y, 1e-4 * scale);
    ASSERT_NEAR(shear[2 * i + 1], 2 * nu_x, 1e-4 * scale);
    most = std::max(most, std::hypot(nu_x, nu_y));
  }
  EXPECT_GT(most, 0.01 * scale);
}

}  // namespace
}  // namespace rouleau::effects
