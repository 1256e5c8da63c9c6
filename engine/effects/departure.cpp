#include "engine/effects/departure.h"

#include <algorithm>

#include "engine/cells/shape.h"

namespace rouleau::effects {

namespace {

using particles::Group;

// In spacings before an outlet.
constexpr double fading_begins = 10;
constexpr double gone = 4;

/// How far a cell's foremost node is from the outlet that it comes nearest to.
struct Approach {
  double distance = 1e300;
  int outlet = 0;
};

class Departing : public CellEffect {
 public:
  void apply(State& state) override {
    bool any_gone = false;
    for (std::size_t c = 0; c < state.cells.size(); ++c) {
      CellState& cell = state.cells[c];
      if (cell.departure) continue;
      const Approach approach = approach_of(state, cell);
      cell.presence = presence_at(approach.distance / state.spacing);
      if (cell.presence > 0) continue;
      const cells::Shape shape = cells::measure(state.ring(cell));
      cell.departure = {state.time + state.dt, approach.outlet, shape.x, shape.y};
      any_gone = true;
    }
    if (any_gone) dissolve(state);
  }

 private:
  static Approach approach_of(const State& state, const CellState& cell) {
    Approach nearest;
    const auto& outlets = state.outline.outlets();
    for (int q = cell.first_node; q < cell.first_node + cell.nodes; ++q) {
      const double x = state.particles.x[q], y = state.particles.y[q];
      for (std::size_t k = 0; k < outlets.size(); ++k) {
        const double across = outlets[k].across(x, y);
        // The plane goes on beyond the branch that ends there.
        if (across < -state.spacing || across > outlets[k].width + state.spacing) continue;
        const double distance = -outlets[k].beyond(x, y);
        if (distance < nearest.distance) nearest = {distance, static_cast<int>(k)};
      }
    }
    return nearest;
  }

  static double presence_at(double spacings) {
    const double s = std::clamp((spacings - gone) / (fading_begins - gone), 0.0, 1.0);
    return s * s * (3 - 2 * s);
  }

  /// Makes plasma of the cells that have gone, and gives the others the first nodes that they will have once
  /// the particles are sorted.
  static void dissolve(State& state) {
    auto& particles = state.particles;
    for (int i = 0; i < particles.size(); ++i) {
      if (particles.cell[i] < 0 || !state.cells[particles.cell[i]].departure) continue;
      particles.cell[i] = -1;
      particles.group[i] = Group::fluid;
    }
    int first = 0;
    for (CellState& cell : state.cells) {
      if (cell.departure) cell.nodes = 0;
      cell.first_node = first;
      first += cell.nodes;
    }
  }
};

}  // namespace

const EffectKind departure{
    "departure",
    Stage::boundaries,
    false,
    [](const Case& scene) { return needs_cells_that_leave(scene, "cells can leave through the outlet"); },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<Departing>(); },
    CellEffect::rests,
    {},
    {.once = 240, .membrane_node = 2.8}};

}  // namespace rouleau::effects
