#include "engine/observe/cell_measures.h"

#include "engine/cells/shape.h"
#include "engine/observe/first_nodes.h"

namespace rouleau::observe {

CellMeasures measure_cell(const effects::State& state, const effects::CellState& cell) {
  const auto nodes = static_cast<std::size_t>(cell.nodes);
  const cells::Ring ring = state.ring(cell);
  const cells::Shape shape = cells::measure(ring);
  const auto velocity = cells::centroid_velocity(ring, {&state.particles.u[cell.first_node], nodes},
                                                 {&state.particles.v[cell.first_node], nodes});
  // Equal masses are those of the nodes that the cell had at first.
  const double inertia_nodes = cells::measure(first_nodes(state, cell).ring()).inertia_nodes;
  const Scales& s = state.scales;
  return {.x = shape.x * s.length,
          .y = shape.y * s.length,
          .u = velocity[0] * s.velocity,
          .v = velocity[1] * s.velocity,
          .tau = inertia_nodes / cell.start_inertia_nodes,
          .tau_area = shape.inertia_area / cell.start_inertia_area,
          .area = shape.area * s.length * s.length,
          .perimeter = shape.perimeter * s.length,
          .angle = shape.angle};
}

}  // namespace rouleau::observe
