#include "engine/observe/first_nodes.h"

#include "engine/cells/resample.h"

namespace rouleau::observe {

FirstNodes first_nodes(const effects::State& state, const effects::CellState& cell) {
  const std::vector<double> places = cell.material.rest_lengths.empty() || cell.departure
                                         ? std::vector<double>{}
                                         : cells::equal_steps(cell.material.rest_lengths, cell.start_nodes);
  const auto carried = [&](const std::vector<double>& field) {
    const auto nodes = std::span(field).subspan(cell.first_node, cell.nodes);
    return places.empty() ? std::vector<double>(nodes.begin(), nodes.end())
                          : cells::interpolate(nodes, places);
  };
  const auto& particles = state.particles;
  return {carried(particles.x), carried(particles.y), carried(particles.u), carried(particles.v),
          carried(particles.p)};
}

}  // namespace rouleau::observe
