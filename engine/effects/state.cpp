#include "engine/effects/state.h"

#include <cmath>

namespace rouleau::effects {

namespace {

/// Room for the walls' ghosts and the buffers beyond both ends.
particles::Extent extent_of(const geometry::Outline& outline, double spacing) {
  const geometry::Bounds b = outline.bounds();
  const double margin_x = outline.period_x() > 0 ? 0 : 10 * spacing;
  const double margin_y = outline.period_y() > 0 ? 0 : 10 * spacing;
  return {b.x0 - margin_x, b.y0 - margin_y, b.x1 + margin_x, b.y1 + margin_y};
}

}  // namespace

State::State(const Case& scene_given, const Scales& scales_given, double spacing_given,
             double start_spacing_given)
    : scene(scene_given),
      scales(scales_given),
      outline(scene, scales.length, scales.velocity),
      spacing(spacing_given),
      start_spacing(start_spacing_given),
      viscosity(scene.plasma.kinematic_viscosity / scales.viscosity()),
      radius(scene.numerics.kernel_radius * spacing),
      near_radius(scene.numerics.preset == Preset::paper ? radius : 2.1 * spacing),
      neighbours(extent_of(outline, spacing), radius, near_radius, outline.period_x(), outline.period_y()),
      projection(neighbours, spacing) {}

cells::Ring State::ring(const CellState& cell) const {
  const auto nodes = static_cast<std::size_t>(cell.nodes);
  return {{&particles.x[cell.first_node], nodes}, {&particles.y[cell.first_node], nodes}};
}

int State::rows_across(double width) const {
  return static_cast<int>(std::lround(width / spacing)) - 1;
}

int State::rows() const {
  return rows_across(outline.height());
}

double State::row_y(int k) const {
  return outline.height() * k / (rows() + 1);
}

double State::row_offset(int k) const {
  if (starts_as_published(scene)) return 0;
  return (std::fmod(0.618034 * k, 1.0) - 0.5) * spacing;
}

operators::SamplingPlane State::plane_at(double x) const {
  return {{x, 0}, {x, outline.height()}, {radius}, 2 * (rows() + 1)};
}

}  // namespace rouleau::effects
