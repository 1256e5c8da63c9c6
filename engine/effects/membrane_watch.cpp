#include "engine/effects/membrane_watch.h"

#include <algorithm>
#include <cmath>

#include "engine/cells/gap.h"
#include "engine/cells/ring_image.h"
#include "engine/cells/shape.h"
#include "engine/effects/bounds.h"
#include "engine/effects/breach.h"

namespace rouleau::effects {

namespace {

class MembraneWatch : public CellEffect {
 public:
  void apply(State& state) override {
    boxes_.clear();
    for (const CellState& cell : state.cells) boxes_.emplace_back(state.ring(cell));
    for (int c = 0; c < static_cast<int>(state.cells.size()); ++c) {
      // Before an outlet a membrane fades: it holds nothing any more.
      if (state.cells[c].departure || state.cells[c].presence < 1) continue;
      check_size(state, c);
      check_crossing(state, c);
    }
  }

 private:
  void check_size(State& state, int c) const {
    const CellState& cell = state.cells[c];
    const cells::Ring ring = boxes_[c].ring();
    const double area = cells::area(ring), perimeter = cells::perimeter(ring);
    const double drift = std::abs(area / cell.start_area - 1);
    const double stretch = perimeter / cell.start_perimeter;
    CellExtremes& extremes = state.counters.cells[c];
    const double jump = std::abs(area / cell.start_area - extremes.area);
    const auto exceeded = [&](const char* quantity, double value, double bound, bool mendable = false) {
      const cells::Shape shape = cells::measure(ring);
      return breach_of_cell(state, c, shape.x, shape.y, {quantity, value, bound, "1", mendable});
    };
    if (!(jump <= area_step_bound)) {
      throw exceeded("change of a cell's area in a step", jump, area_step_bound, true);
    }
    if (!(drift <= area_bound)) throw exceeded("change of a cell's area", drift, area_bound);
    if (!(stretch >= least_perimeter))
      throw exceeded("perimeter over that at the start", stretch, least_perimeter);
    if (!(stretch <= most_perimeter))
      throw exceeded("perimeter over that at the start", stretch, most_perimeter);
    extremes.area = area / cell.start_area;
    extremes.area_drift = std::max(extremes.area_drift, drift);
    extremes.least_perimeter = std::min(extremes.least_perimeter, stretch);
    extremes.most_perimeter = std::max(extremes.most_perimeter, stretch);
    const double thickness = 2 * area / perimeter / state.spacing;
    if (thickness < extremes.least_thickness) {
      extremes.least_thickness = thickness;
      extremes.thinnest_time = state.time + state.dt;
    }
  }

  void check_crossing(const State& state, int c) const {
    auto crossing = cells::find_crossing(boxes_[c]);
    for (std::size_t other = c + 1; other < boxes_.size() && !crossing; ++other) {
      if (state.cells[other].presence < 1) continue;
      crossing = cells::find_crossing(boxes_[c], boxes_[other]);
    }
    state.outline.visit_images([&](double dx, double dy) {
      for (std::size_t other = c; other < boxes_.size() && !crossing; ++other) {
        crossing = crossing_of_image(boxes_[c], dx, dy, boxes_[other]);
      }
    });
    if (crossing) {
      throw breach_of_cell(state, c, crossing->x, crossing->y, {"crossing membrane edges", 1, 0});
    }
  }

  static std::optional<cells::Crossing> crossing_of_image(const cells::LinkBoxes& a, double away_x,
                                                          double away_y, const cells::LinkBoxes& b) {
    if (a.whole().displaced(away_x, away_y).distance(b.whole()) > 0) return std::nullopt;
    return cells::find_crossing(cells::RingImage(a.ring(), away_x, away_y).boxes(), b);
  }

  std::vector<cells::LinkBoxes> boxes_;
};

}  // namespace

const EffectKind membrane_watch{
    "membrane_watch",
    Stage::checks,
    false,
    [](const Case& scene) { return of_accurate_scheme(scene, needs_cells(scene, "a cell must stay whole")); },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<MembraneWatch>(); },
    CellEffect::rests,
    {},
    {.particle = 0.8, .membrane_node = 70}};

}  // namespace rouleau::effects
