#include "engine/simulation/lasting.h"

#include <algorithm>
#include <cmath>

namespace rouleau {

namespace {

using particles::Group;

// Spacings beyond the vessel in which there are particles.
constexpr double surroundings = 20;

void require(bool holds, const char* what) {
  if (!holds) throw CheckpointError(std::string("the checkpoint is damaged: ") + what);
}

bool all_finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

void check_particles(const effects::State& state) {
  const auto& set = state.particles;
  const std::size_t n = set.x.size();
  for (const auto* field : {&set.x, &set.y, &set.u, &set.v, &set.p, &set.du, &set.dv, &set.phi}) {
    require(field->size() == n, "its particles' fields differ in length");
    require(all_finite(*field), "it holds a value that is no number");
  }
  require(set.cell.size() == n && set.id.size() == n && set.group.size() == n,
          "its particles' fields differ in length");
  const geometry::Bounds b = state.outline.bounds();
  const double room = surroundings * state.spacing;
  const auto cells = static_cast<std::int32_t>(state.cells.size());
  for (std::size_t i = 0; i < n; ++i) {
    require(set.group[i] < Group::dead, "a particle is of no known kind");
    require(set.cell[i] >= -1 && set.cell[i] < cells, "a particle belongs to no cell that there is");
    require(
        set.x[i] > b.x0 - room && set.x[i] < b.x1 + room && set.y[i] > b.y0 - room && set.y[i] < b.y1 + room,
        "a particle is far outside the vessel");
  }
}

/// The membranes are the first particles, cell by cell.
void check_membranes(const effects::State& state) {
  const auto& set = state.particles;
  std::size_t node = 0;
  for (std::size_t c = 0; c < state.cells.size(); ++c) {
    const effects::CellState& cell = state.cells[c];
    require(cell.departure ? cell.nodes == 0 : cell.nodes >= 3, "a cell has no membrane");
    require(cell.first_node >= 0 && static_cast<std::size_t>(cell.first_node) == node,
            "the cells are out of order");
    const std::size_t end = node + static_cast<std::size_t>(cell.nodes);
    require(end <= set.x.size(), "a membrane is incomplete");
    const auto& rest_lengths = cell.material.rest_lengths;
    require(
        cell.departure || rest_lengths.empty() || rest_lengths.size() == static_cast<std::size_t>(cell.nodes),
        "a membrane's links differ in number from its nodes");
    require(
        cell.start_nodes >= 3 && cell.first_id >= 0 && cell.start_nodes < 100000 && all_finite(rest_lengths),
        "a membrane has not begun as one");
    const auto& [held, tension] = cell.held;
    require(held.size() == tension.size() &&
                (cell.departure || held.empty() || held.size() == static_cast<std::size_t>(cell.nodes)),
            "a membrane's held links differ in number from its nodes");
    require(all_finite(held) && all_finite(tension), "it holds a value that is no number");
    for (; node < end; ++node) {
      require(set.group[node] == Group::membrane && set.cell[node] == static_cast<std::int32_t>(c),
              "a membrane is incomplete");
    }
  }
  const auto membranes = std::count(set.group.begin(), set.group.end(), Group::membrane);
  require(static_cast<std::size_t>(membranes) == node, "a membrane belongs to no cell");
}

}  // namespace

void check_spacing(double spacing, const effects::State& state) {
  require(spacing <= state.start_spacing && spacing > 0.1 * state.start_spacing,
          "its spacing is none of the case's");
}

void check_lasting(const effects::State& state, std::size_t lanes) {
  require(state.time >= 0 && std::isfinite(state.time) && state.step >= 0, "its time is none of a run");
  require(state.dt >= 0 && state.last_dt >= 0 && std::isfinite(state.dt) && std::isfinite(state.last_dt) &&
              state.speed >= 0,
          "its time step is none of a run");
  require(state.cells.size() == state.scene.cells.size() && state.counters.cells.size() == state.cells.size(),
          "it has not the case's cells");
  require(state.lanes.size() == lanes, "it has not the case's inlet");
  check_particles(state);
  check_membranes(state);
}

}  // namespace rouleau
