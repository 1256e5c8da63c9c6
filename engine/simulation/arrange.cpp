#include "engine/simulation/arrange.h"

#include <cmath>
#include <numbers>
#include <string>

#include "engine/case/case_error.h"
#include "engine/cells/rest_shape.h"
#include "engine/cells/shape.h"
#include "engine/cells/tank_treading.h"
#include "engine/simulation/initial_velocity.h"

namespace rouleau {

namespace {

using effects::CellState;
using effects::State;
using particles::Group;

// In spacings: how near to a wall and to a membrane fluid is put.
constexpr double wall_gap = 0.55;
constexpr double membrane_gap = 0.5;
constexpr double published_membrane_gap = 0.6;  // nearer ones are shot off by their number density (eq. 7)
constexpr int ghost_layers = 3;
constexpr double wall_extension = 8;

cells::RestShape find_rest_shape(const CellState& cell, double area, int index) {
  try {
    return cells::rest_shape(cell.material, cell.nodes, area);
  } catch (const cells::RestShapeError& error) {
    throw CaseError(
        {{"/cells/" + std::to_string(index),
          "no rest shape was found for its moduli and fill at this spacing: " + std::string(error.what())}});
  }
}

CellState place_cell(State& state, const RedCell& cell, int index) {
  const Scales& scales = state.scales;
  const double diameter = cell.diameter / scales.length;
  CellState placed;
  placed.first_node = state.particles.size();
  placed.nodes = static_cast<int>(std::lround(std::numbers::pi * diameter / state.spacing));
  placed.material = {cell.stretch_modulus / scales.tension(), cell.bend_modulus / scales.bending(),
                     std::numbers::pi * diameter / placed.nodes};
  // Eq. 10 knows no crushing.
  if (state.scene.numerics.preset == Preset::paper) placed.material.crush_stiffening = 0;
  const double circle = std::numbers::pi * diameter * diameter / 4;
  if (deflates(cell)) placed.circle_area = circle;
  const double area = (cell.shape == CellShape::circle ? 1 : cell.fill) * circle;
  const cells::RestShape shape = find_rest_shape(placed, area, index);
  const double angle = cell.angle * std::numbers::pi / 180;
  for (int q = 0; q < placed.nodes; ++q) {
    const double x = shape.x[q] * std::cos(angle) - shape.y[q] * std::sin(angle);
    const double y = shape.x[q] * std::sin(angle) + shape.y[q] * std::cos(angle);
    state.particles.add(Group::membrane, cell.x / scales.length + x, cell.y / scales.length + y, index);
  }
  return placed;
}

/// A place and, in a periodic vessel, its images next to it.
std::vector<geometry::Point> images(const State& state, double x, double y) {
  const double px = state.outline.period_x(), py = state.outline.period_y();
  std::vector<geometry::Point> found;
  for (const double a : px > 0 ? std::vector{-px, 0.0, px} : std::vector{0.0}) {
    for (const double b : py > 0 ? std::vector{-py, 0.0, py} : std::vector{0.0}) {
      found.push_back({x + a, y + b});
    }
  }
  return found;
}

/// The cell that a place lies in (-1: none), or nothing if a membrane is too near.
bool free_place(const State& state, double x, double y, int& cell) {
  cell = -1;
  const bool published = state.scene.numerics.preset == Preset::paper;
  const double gap = (published ? published_membrane_gap : membrane_gap) * state.spacing;
  for (std::size_t c = 0; c < state.cells.size(); ++c) {
    const cells::Ring ring = state.ring(state.cells[c]);
    for (const auto& [image_x, image_y] : images(state, x, y)) {
      if (cells::nearest(ring, image_x, image_y).distance < gap) return false;
      if (cells::contains(ring, image_x, image_y)) cell = static_cast<int>(c);
    }
  }
  return state.outline.contains(x, y) && state.outline.distance(x, y).value >= wall_gap * state.spacing;
}

/// Evenly spaced places.
struct Lattice {
  double first, gap;
  int count;

  double at(int k) const { return first + k * gap; }
};

/// From wall to wall, both included.
Lattice between_walls(double from, double to, double spacing) {
  const int pieces = static_cast<int>(std::lround((to - from) / spacing));
  return {from, (to - from) / pieces, pieces + 1};
}

/// Half a gap off both ends.
Lattice between_planes(double from, double to, double spacing) {
  const int pieces = static_cast<int>(std::lround((to - from) / spacing));
  const double gap = (to - from) / pieces;
  return {from + 0.5 * gap, gap, pieces};
}

/// Rows on multiples of the spacing, which divides the height of the vessel.
Lattice rows_of(const geometry::Outline& outline, double spacing) {
  const geometry::Bounds bounds = outline.bounds();
  if (outline.period_y() > 0) return between_planes(bounds.y0, bounds.y1, spacing);
  const double first = std::floor(bounds.y0 / spacing + 1e-6);
  const double last = std::ceil(bounds.y1 / spacing - 1e-6);
  return {first * spacing, spacing, static_cast<int>(last - first) + 1};
}

}  // namespace

void place_cells(State& state) {
  for (const RedCell& cell : state.scene.cells) {
    CellState placed = place_cell(state, cell, static_cast<int>(state.cells.size()));
    const cells::Shape shape = cells::measure(state.ring(placed));
    placed.start_area = shape.area;
    placed.start_nodes = placed.nodes;
    placed.first_id = state.particles.id[placed.first_node];
    placed.start_inertia_nodes = shape.inertia_nodes;
    placed.start_inertia_area = shape.inertia_area;
    placed.start_perimeter = shape.perimeter;
    const std::vector<double> at_rest(placed.nodes, 0.0);
    placed.start_phase = cells::tank_treading(state.ring(placed), at_rest, at_rest).phase;
    state.cells.push_back(placed);
  }
  state.counters.cells.resize(state.cells.size());
  const InitialVelocity initial(state);
  auto& particles = state.particles;
  for (int i = 0; i < particles.size(); ++i) {
    const auto [u, v] = initial.at(particles.x[i], particles.y[i]);
    particles.u[i] = u;
    particles.v[i] = v;
  }
}

void place_fluid(State& state) {
  const geometry::Bounds bounds = state.outline.bounds();
  const bool closed = state.scene.vessel.ends == Ends::closed;
  const Lattice along = closed ? between_walls(bounds.x0, bounds.x1, state.spacing)
                               : between_planes(bounds.x0, bounds.x1, state.spacing);
  const Lattice across = rows_of(state.outline, state.spacing);
  const InitialVelocity initial(state);
  for (int k = 0; k < across.count; ++k) {
    const double y = across.at(k);
    const double offset = closed ? 0 : state.row_offset(k);
    for (int m = 0; m < along.count; ++m) {
      const double x = along.at(m) + offset;
      int cell = -1;
      if (!free_place(state, x, y, cell)) continue;
      const int i = state.particles.add(Group::fluid, x, y, cell);
      const auto [u, v] = initial.at(x, y);
      state.particles.u[i] = u;
      state.particles.v[i] = v;
      state.particles.p[i] = initial.pressure(x, y);
      if (cell >= 0) ++state.cells[cell].circle_particles;
    }
  }
}

void place_walls(State& state) {
  auto& particles = state.particles;
  const auto nodes = state.outline.wall_nodes(state.spacing, wall_extension * state.spacing);
  // Upstream of the inlet a plug slips along the walls: they are no velocity data there.
  const bool plug = state.scene.inflow.profile == Profile::plug;
  for (const auto& node : nodes) {
    const int i = particles.add(plug && node.beyond_inlet ? Group::ghost : Group::wall, node.x, node.y);
    particles.u[i] = node.u;
    particles.v[i] = node.v;
  }
  for (const auto& [x, y] : state.outline.ghosts(nodes, ghost_layers, state.spacing)) {
    particles.add(Group::ghost, x, y);
  }
}

}  // namespace rouleau
