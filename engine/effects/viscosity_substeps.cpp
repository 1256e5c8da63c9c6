#include "engine/effects/viscosity_substeps.h"

namespace rouleau::effects {

namespace {

class ViscositySubsteps : public Effect {
 public:
  explicit ViscositySubsteps(const State& state) : mps_(state.spacing, state.radius) {}

  void apply(State& state) override {
    auto& particles = state.particles;
    const int n = particles.active_end();
    weights_.fill(mps_, state.neighbours);
    for (int i = 0; i < n; ++i) {
      particles.u[i] += state.dt * state.ax[i];
      particles.v[i] += state.dt * state.ay[i];
    }
    change_u_.resize(n);
    change_v_.resize(n);
    const int substeps = state.scene.numerics.substeps;
    const double diffusion = state.viscosity * state.dt / substeps;
    for (int m = 0; m < substeps; ++m) {
      for (int i = 0; i < n; ++i) {
        change_u_[i] = operators::laplacian(mps_, state.neighbours, weights_, i, particles.u.data());
        change_v_[i] = operators::laplacian(mps_, state.neighbours, weights_, i, particles.v.data());
      }
      for (int i = 0; i < n; ++i) {
        particles.u[i] += diffusion * change_u_[i];
        particles.v[i] += diffusion * change_v_[i];
      }
    }
  }

 private:
  operators::StandardMps mps_;
  operators::KernelWeights weights_;
  std::vector<double> change_u_, change_v_;
};

}  // namespace

const EffectKind viscosity_substeps{
    "viscosity_substeps",
    Stage::viscosity,
    false,
    [](const Case& scene) {
      return of_published_scheme(scene, "plasma is viscous: M = " + std::to_string(scene.numerics.substeps) +
                                            " explicit sub-steps (the study does not print M)");
    },
    [](State& state) -> std::unique_ptr<Effect> { return std::make_unique<ViscositySubsteps>(state); },
    "",
    {},
    {.each = 18.5, .count = [](const Work& w) { return w.particles * w.scene.numerics.substeps; }}};

}  // namespace rouleau::effects
