#include "engine/observe/unit_flow.h"

#include "engine/observe/flow_planes.h"
#include "engine/observe/fluid_segments.h"

namespace rouleau::observe {

namespace {

// In spacings, on either side of a point, where its velocity gradient is taken.
constexpr double half_step = 0.5;

class Poiseuille : public UnitFlow {
 public:
  explicit Poiseuille(const effects::State& start)
      : length_(start.outline.length()), height_(start.outline.height()), viscosity_(start.viscosity) {}

  double drive() const override { return slope() * length_; }
  std::array<double, 2> velocity(double, double y) const override {
    return {effects::State::parabola(y / height_) / height_, 0};
  }
  std::array<double, 3> stress(double x, double y) const override {
    const double pressure = slope() * (length_ - x);
    return {-pressure, slope() * (height_ / 2 - y), -pressure};
  }

 private:
  double slope() const { return 12 * viscosity_ / (height_ * height_ * height_); }

  double length_, height_, viscosity_;
};

class SettledFlow : public UnitFlow {
 public:
  explicit SettledFlow(std::unique_ptr<const effects::State> state)
      : state_(std::move(state)), sampler_(state_->particles, sampling_reach(*state_), box()) {
    const operators::CrossSection inlet = measure(state_->particles, flow_planes(*state_).inlet);
    flux_ = inlet.flux;
    drive_ = drive_of(*state_, inlet) / flux_;
  }

  double drive() const override { return drive_; }
  std::array<double, 2> velocity(double x, double y) const override {
    const operators::Velocity at = sampler_.velocity(x, y);
    return {at.u / flux_, at.v / flux_};
  }
  std::array<double, 3> stress(double x, double y) const override {
    const double h = half_step * state_->spacing;
    const auto east = velocity(x + h, y), west = velocity(x - h, y);
    const auto north = velocity(x, y + h), south = velocity(x, y - h);
    const double nu = state_->viscosity, pressure = sampler_.pressure(x, y) / flux_;
    return {nu * (east[0] - west[0]) / h - pressure, nu * (north[0] - south[0] + east[1] - west[1]) / (2 * h),
            nu * (north[1] - south[1]) / h - pressure};
  }

 private:
  operators::SamplingBox box() const {
    const geometry::Bounds& b = state_->outline.bounds();
    const double margin = state_->spacing;
    return {b.x0 - margin, b.y0 - margin, b.x1 + margin, b.y1 + margin};
  }

  std::unique_ptr<const effects::State> state_;
  operators::Sampler sampler_;
  double flux_ = 1, drive_ = 0;
};

}  // namespace

std::unique_ptr<const UnitFlow> unit_flow(const effects::State& start, const CellFreeFlow& cell_free) {
  const Case& scene = start.scene;
  const bool is_parabola = !is_open(scene.vessel) || scene.inflow.profile == Profile::parabolic;
  if (scene.vessel.shape == Shape::straight && scene.thrombi.empty() && is_parabola)
    return std::make_unique<Poiseuille>(start);
  return std::make_unique<SettledFlow>(cell_free());
}

double drive_of(const effects::State& state, const operators::CrossSection& inlet) {
  if (is_open(state.scene.vessel)) return pressure_drop(state, inlet);
  return state.scene.body_acceleration[0] / state.scales.acceleration() * state.outline.length();
}

}  // namespace rouleau::observe
