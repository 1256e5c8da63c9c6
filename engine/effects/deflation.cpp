#include "engine/effects/deflation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rouleau::effects {

namespace {

using particles::Group;

class Deflation : public Effect {
 public:
  bool awake(const State& state) override {
    for (std::size_t c = 0; c < state.cells.size(); ++c) {
      const CellState& cell = state.cells[c];
      if (cell.circle_area == 0 || cell.nodes == 0) continue;
      if (cell.area_rate != 0 || cell.start_area != deflated_area(state, state.scene.cells[c])) return true;
    }
    return false;
  }

  void apply(State& state) override {
    for (std::size_t c = 0; c < state.cells.size(); ++c) {
      CellState& cell = state.cells[c];
      if (cell.circle_area == 0 || cell.nodes == 0) continue;
      set_area(state, state.scene.cells[c], cell);
      const double square = state.spacing * state.spacing;
      const double lost = (cell.circle_area - cell.start_area) / square;
      const int particles = cell.circle_particles - static_cast<int>(std::lround(lost));
      thin_out(state, static_cast<int>(c), particles);
      // The sink is in the particles inside, whose area is the cell's without what its nodes stand for.
      cell.area_rate /= std::max(particles, 1) * square;
    }
  }

 private:
  static double deflated_area(const State& state, const RedCell& given) {
    const double diameter = given.diameter / state.scales.length;
    return given.fill * std::numbers::pi * diameter * diameter / 4;
  }

  /// The area falls evenly while the unit of velocity, in an open vessel the mean inflow, covers the cell's
  /// diameter.
  static void set_area(const State& state, const RedCell& given, CellState& cell) {
    const double diameter = given.diameter / state.scales.length;
    const double deflated = deflated_area(state, given);
    const double progress = std::min((state.time + state.dt) / diameter, 1.0);
    cell.start_area = std::lerp(cell.circle_area, deflated, progress);
    cell.area_rate = progress < 1 ? (deflated - cell.circle_area) / diameter : 0;
  }

  static void thin_out(State& state, int c, int wanted) {
    auto& particles = state.particles;
    int inside = 0;
    for (int i = particles.membrane_end(); i < particles.active_end(); ++i) inside += encloses(state, c, i);
    for (; inside > wanted; --inside) {
      int most = -1;
      double most_crowded = -1;
      for (int i = particles.membrane_end(); i < particles.active_end(); ++i) {
        if (!encloses(state, c, i)) continue;
        const double here = crowding(state, i);
        if (here <= most_crowded) continue;
        most = i;
        most_crowded = here;
      }
      if (most < 0) return;
      particles.group[most] = Group::dead;
    }
  }

  static bool encloses(const State& state, int c, int i) {
    return state.particles.cell[i] == c && state.particles.group[i] == Group::fluid;
  }

  static double crowding(const State& state, int i) {
    const auto& list = state.neighbours;
    double sum = 0;
    for (int k = list.begin(i); k < list.near_end(i); ++k) {
      const double q = 1 - list.r[k] / state.near_radius;
      if (state.particles.group[list.j[k]] != Group::dead) sum += q * q * q;
    }
    return sum;
  }
};

}  // namespace

const EffectKind deflation{
    "deflation",
    Stage::boundaries,
    false,
    [](const Case& scene) {
      const bool any = std::any_of(scene.cells.begin(), scene.cells.end(), deflates);
      return Need{any, any ? "a cell deflates from its circle" : "no cell starts as a circle to deflate",
                  "/cells"};
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<Deflation>(); },
    "once every cell has its area",
    {},
    {.particle = 3}};

}  // namespace rouleau::effects
