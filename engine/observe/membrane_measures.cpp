#include "engine/observe/membrane_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/cells/gap.h"
#include "engine/cells/ring_image.h"
#include "engine/cells/shape.h"
#include "engine/cells/tank_treading.h"
#include "engine/observe/first_nodes.h"

namespace rouleau::observe {

namespace {

// Slower than this, in mean inflow velocities, a cell is at rest: its shape is seen against the vessel.
constexpr double at_rest = 1e-3;

double gap_to_others(const effects::State& state, std::size_t k) {
  double least = std::numeric_limits<double>::infinity();
  const cells::LinkBoxes own(state.ring(state.cells[k]));
  for (std::size_t other = 0; other < state.cells.size(); ++other) {
    if (other == k || state.cells[other].nodes == 0) continue;
    const cells::LinkBoxes boxes(state.ring(state.cells[other]));
    if (own.whole().distance(boxes.whole()) < least) least = std::min(least, cells::least_gap(own, boxes));
    state.outline.visit_images([&](double dx, double dy) {
      if (own.whole().displaced(dx, dy).distance(boxes.whole()) >= least) return;
      least = std::min(least, cells::least_gap(cells::RingImage(own.ring(), dx, dy).boxes(), boxes));
    });
  }
  return least;
}

}  // namespace

MembraneMeasures measure_membrane(const effects::State& state, std::size_t k) {
  const effects::CellState& cell = state.cells[k];
  const cells::Ring ring = state.ring(cell);
  const FirstNodes first = first_nodes(state, cell);
  const cells::TankTreading treading = cells::tank_treading(first.ring(), first.u, first.v);
  std::array<double, 2> motion = cells::centroid_velocity(first.ring(), first.u, first.v);
  if (std::hypot(motion[0], motion[1]) < at_rest) motion = {1, 0};
  const cells::Strain strain = cells::strain(first.ring(), cell.material.rest_length);
  const Scales& s = state.scales;
  return {.mean_strain = strain.mean,
          .greatest_strain = strain.greatest,
          .tank_treading_phase = cells::axis_angle(treading.phase - cell.start_phase),
          .tank_treading_frequency = treading.frequency / s.time(),
          .shape = cells::classify(ring, motion),
          .thickness = cells::thickness(ring) * s.length,
          .wall_gap = cells::wall_gap(ring, state.outline) * s.length,
          .cell_gap = gap_to_others(state, k) * s.length};
}

}  // namespace rouleau::observe
