#include "engine/effects/exact_projection.h"

#include <algorithm>
#include <cmath>

namespace rouleau::effects {

namespace {

// Divergence that is left alone, in velocities over spacings: in smooth flow there is less.
constexpr double harmless = 6e-3;
constexpr int most_iterations = 300;
// Where a plug meets the walls its velocity jumps, and the fits find divergence that means nothing: up to
// here from the inlet, in spacings, it is left alone.
constexpr double plug_corner = 3;

/// The Laplacian of the pressure equation is compact, the divergence of its gradient is not, so that between
/// a membrane and a wall or behind a thrombus some divergence e stays. With D the divergence by the fits, the
/// least change of velocity that takes it out is -D^T l where D D^T l = e: by conjugate gradients from l = 0,
/// stopped as soon as nothing exceeds `harmless`. The pressure is left as it is.
class ExactProjection : public Effect {
 public:
  bool awake(const State& state) override {
    const auto n = static_cast<std::size_t>(state.particles.active_end());
    operators::interleave(state.particles.u, state.particles.v, velocity_);
    state.operators.divergences(velocity_.data(), residual_);
    const bool plug = is_open(state.scene.vessel) && state.scene.inflow.profile == Profile::plug;
    const double from = plug ? plug_corner * state.spacing : -1e300;
    for (std::size_t i = 0; i < n; ++i) {
      residual_[i] = state.particles.x[i] < from ? 0 : residual_[i] - state.source[i];
    }
    return greatest(residual_) > harmless / state.spacing;
  }

  void apply(State& state) override {
    const auto n = static_cast<std::size_t>(state.particles.active_end());
    const double goal = harmless / state.spacing;
    find_diagonal(state);
    correction_.assign(2 * n, 0);
    direction_.assign(n, 0);
    double before = 0;
    for (int k = 0; k < most_iterations && greatest(residual_) > goal; ++k) {
      double size = 0;
      for (std::size_t i = 0; i < n; ++i) size += residual_[i] * residual_[i] * inverse_diagonal_[i];
      const double beta = k > 0 ? size / before : 0;
      before = size;
      for (std::size_t i = 0; i < n; ++i) {
        direction_[i] = residual_[i] * inverse_diagonal_[i] + beta * direction_[i];
      }
      transpose(state);
      state.operators.divergences(change_.data(), image_);
      double curvature = 0;
      for (std::size_t i = 0; i < n; ++i) curvature += direction_[i] * image_[i];
      if (!(curvature > 0)) break;
      const double length = size / curvature;
      for (std::size_t i = 0; i < n; ++i) residual_[i] -= length * image_[i];
      for (std::size_t i = 0; i < 2 * n; ++i) correction_[i] += length * change_[i];
    }
    for (std::size_t i = 0; i < n; ++i) {
      state.particles.u[i] -= correction_[2 * i];
      state.particles.v[i] -= correction_[2 * i + 1];
    }
  }

 private:
  static double greatest(const std::vector<double>& values) {
    double most = 0;
    for (const double value : values) most = std::max(most, std::abs(value));
    return most;
  }

  /// Of D D^T.
  void find_diagonal(const State& state) {
    const auto& list = state.neighbours;
    const int n = list.rows();
    inverse_diagonal_.resize(n);
    for (int i = 0; i < n; ++i) {
      const float *dx = state.operators.dx(i), *dy = state.operators.dy(i);
      double own_x = 0, own_y = 0, squares = 0;
      for (int k = 0; k < list.end(i) - list.begin(i); ++k) {
        const double x = dx[k], y = dy[k];
        own_x += x;
        own_y += y;
        if (list.j[list.begin(i) + k] < n) squares += x * x + y * y;
      }
      inverse_diagonal_[i] = 1 / (squares + own_x * own_x + own_y * own_y);
    }
  }

  /// change = D^T direction, at the active particles alone: the velocities of the others are given.
  void transpose(const State& state) {
    const auto& list = state.neighbours;
    const int n = list.rows();
    change_.assign(2 * state.particles.x.size(), 0);
    for (int i = 0; i < n; ++i) {
      const float *dx = state.operators.dx(i), *dy = state.operators.dy(i);
      double own_x = 0, own_y = 0;
      for (int k = 0; k < list.end(i) - list.begin(i); ++k) {
        const double x = dx[k] * direction_[i], y = dy[k] * direction_[i];
        const int j = list.j[list.begin(i) + k];
        change_[2 * j] += x;
        change_[2 * j + 1] += y;
        own_x += x;
        own_y += y;
      }
      change_[2 * i] -= own_x;
      change_[2 * i + 1] -= own_y;
    }
    std::fill(change_.begin() + 2 * n, change_.end(), 0);
  }

  std::vector<double> velocity_, inverse_diagonal_;
  std::vector<double> residual_;  ///< the divergence that `awake` found, then what is left of it
  std::vector<double> direction_, change_, image_, correction_;
};

/// Particles, if so much divergence is left that some iterations are needed: at spacings that are coarse
/// beside the shear at a cell or a fork, from runs.
double rough_particles(const Work& work) {
  double shear = work.scene.vessel.shape == Shape::bifurcation ? 1.4 / work.gap : 0;
  for (const RedCell& cell : work.scene.cells) {
    const double across = work.scene.vessel.diameter / work.spacing;
    shear = std::max(shear, 3 * cell.diameter / work.scene.vessel.diameter / across);
  }
  return is_open(work.scene.vessel) ? work.particles * std::clamp((shear - 0.045) / 0.01, 0.0, 1.0) : 0;
}

}  // namespace

const EffectKind exact_projection{
    "exact_projection",
    Stage::pressure,
    true,
    [](const Case& scene) {
      // What the corners under a moving lid leave is theirs, and in the smooth flow of boxes there is none.
      if (scene.cells.empty() && !is_open(scene.vessel))
        return Need{false, "a vessel without ends and cells leaves the pressure no rough divergence",
                    "/vessel/ends"};
      return of_accurate_scheme(scene, always("beside walls and membranes the pressure leaves divergence"));
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<ExactProjection>(); },
    "while no divergence exceeds 0.006 U/d0",
    {},
    {.particle = 29, .each = 95, .count = rough_particles}};

}  // namespace rouleau::effects
