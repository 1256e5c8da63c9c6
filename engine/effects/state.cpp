#include "engine/effects/state.h"

#include <cmath>

namespace rouleau::effects {

namespace {

/// Room for the walls' ghosts and the buffers beyond both ends.
particles::Extent extent_of(const geometry::Outline& outline, double spacing) {
  const double margin = 10 * spacing;
  const geometry::Bounds& b = outline.bounds();
  return {b.x0 - margin, b.y0 - margin, b.x1 + margin, b.y1 + margin};
}

}  // namespace

State::State(const Case& scene_given, const Scales& scales_given, double spacing_given)
    : scene(scene_given),
      scales(scales_given),
      outline(scene, scales.length, scales.velocity),
      spacing(spacing_given),
      viscosity(scene.plasma.kinematic_viscosity / scales.viscosity()),
      radius(scene.numerics.kernel_radius * spacing),
      near_radius(scene.numerics.preset == Preset::paper ? radius : 2.1 * spacing),
      neighbours(extent_of(outline, spacing), radius, near_radius),
      projection(neighbours, spacing) {}

cells::Ring State::ring(const CellState& cell) const {
  const auto nodes = static_cast<std::size_t>(cell.nodes);
  return {{&particles.x[cell.first_node], nodes}, {&particles.y[cell.first_node], nodes}};
}

int State::rows() const {
  return static_cast<int>(std::lround(outline.height() / spacing)) - 1;
}

double State::row_y(int k) const {
  return outline.height() * k / (rows() + 1);
}

double State::row_offset(int k) const {
  return (std::fmod(0.618034 * k, 1.0) - 0.5) * spacing;
}

operators::SamplingPlane State::plane_at(double x) const {
  return {{x, 0}, {x, outline.height()}, {radius}, 2 * (rows() + 1)};
}

double State::developed_velocity(double y) const {
  const double height = outline.height();
  const double from_axis = 2 * y / height - 1;
  return 1.5 * (1 - from_axis * from_axis);
}

}  // namespace rouleau::effects
