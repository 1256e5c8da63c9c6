#pragma once

#include <span>
#include <vector>

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// One elastic energy of the membranes as an effect: its forces on the nodes and the stiffness that the
/// viscous step takes into account.
class ElasticEnergy : public CellEffect {
 public:
  using AddForces = void (*)(cells::Ring, const cells::Material&, std::span<double>, std::span<double>);
  using AppendStiffness = void (*)(cells::Ring, const cells::Material&, int, std::vector<cells::Stiffness>&);

  ElasticEnergy(AddForces add_forces, AppendStiffness append_stiffness)
      : add_forces_(add_forces), append_stiffness_(append_stiffness) {}

  void apply(State& state) override {
    for (const CellState& cell : state.cells) {
      const auto nodes = static_cast<std::size_t>(cell.nodes);
      add_forces_(state.ring(cell), cell.material, {&state.load.fx[cell.first_node], nodes},
                  {&state.load.fy[cell.first_node], nodes});
      append_stiffness_(state.ring(cell), cell.material, cell.first_node, state.load.stiffness);
    }
  }

 private:
  AddForces add_forces_;
  AppendStiffness append_stiffness_;
};

}  // namespace rouleau::effects
