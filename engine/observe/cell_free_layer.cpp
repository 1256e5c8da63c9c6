#include "engine/observe/cell_free_layer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/observe/fluid_segments.h"

namespace rouleau::observe {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double none = std::numeric_limits<double>::quiet_NaN();
// In spacings, between two stations.
constexpr double station_distance = 0.5;

constexpr std::array<const char*, 2> wall_names{"lower", "upper"};

/// A membrane, perhaps displaced by a period, within a circle.
struct Target {
  cells::Ring ring;
  double away_x = 0, away_y = 0;
  double x = 0, y = 0, radius = 0;
};

Target target_of(cells::Ring ring) {
  const auto [left, right] = std::minmax_element(ring.x.begin(), ring.x.end());
  const auto [low, high] = std::minmax_element(ring.y.begin(), ring.y.end());
  return {ring, 0, 0, (*left + *right) / 2, (*low + *high) / 2, std::hypot(*right - *left, *high - *low) / 2};
}

std::vector<Target> targets_in(const effects::State& state) {
  std::vector<Target> targets;
  for (const effects::CellState& cell : state.cells) {
    if (cell.departure) continue;
    const Target own = target_of(state.ring(cell));
    targets.push_back(own);
    state.outline.visit_images([&](double dx, double dy) {
      targets.push_back({own.ring, dx, dy, own.x + dx, own.y + dy, own.radius});
    });
  }
  return targets;
}

/// How far a ray gets before it meets the membrane; infinite if it does not.
double way_to(const Target& target, double x, double y, double nx, double ny) {
  const double aside = (target.x - x) * ny - (target.y - y) * nx;
  if (std::abs(aside) > target.radius) return infinity;
  const auto seen = [&](std::size_t i) {
    const double dx = target.ring.x[i] + target.away_x - x, dy = target.ring.y[i] + target.away_y - y;
    return std::array{dx * ny - dy * nx, dx * nx + dy * ny};  // beside the ray, along it
  };
  double least = infinity;
  auto [from_beside, from_along] = seen(target.ring.size() - 1);
  for (std::size_t i = 0; i < target.ring.size(); ++i) {
    const auto [beside, along] = seen(i);
    if ((from_beside < 0) != (beside < 0)) {
      const double way = from_along + (along - from_along) * from_beside / (from_beside - beside);
      if (way >= 0) least = std::min(least, way);
    }
    from_beside = beside;
    from_along = along;
  }
  return least;
}

class CellFreeLayer : public Observer {
 public:
  explicit CellFreeLayer(const effects::State& start) : layers_(start) {}

  void follow(const effects::State& state) override {
    const auto layers = layers_.measure(state);
    for (std::size_t wall = 0; wall < 2; ++wall) {
      if (std::isnan(layers[wall].mean)) continue;
      sum_[wall] += state.dt * layers[wall].mean * state.scales.length;
      time_[wall] += state.dt;
      least_[wall] = std::min(least_[wall], layers[wall].least * state.scales.length);
    }
  }

  void sample(const effects::State& state, Row& row) override {
    for (const FreeLayer& layer : layers_.measure(state)) {
      row.values.push_back(layer.mean * state.scales.length);
    }
  }

  void report(RunSummary& summary) const override {
    for (std::size_t wall = 0; wall < 2; ++wall) {
      const std::string name = std::string("cell_free_layer.") + wall_names[wall];
      summary.findings.push_back({name + ".mean", time_[wall] > 0 ? sum_[wall] / time_[wall] : none, "m"});
      summary.findings.push_back({name + ".least", least_[wall], "m"});
    }
  }

  void save(ByteWriter& bytes) override { bytes(sum_, time_, least_); }
  void restore(ByteReader& bytes) override { bytes(sum_, time_, least_); }

 private:
  FreeLayers layers_;
  std::array<double, 2> sum_{}, time_{}, least_{infinity, infinity};
};

}  // namespace

FreeLayers::FreeLayers(const effects::State& start) {
  const auto& chains = start.outline.walls();
  walls_ = {wall_of(chains.front(), start), wall_of(chains.back(), start)};
}

FreeLayers::Wall FreeLayers::wall_of(const geometry::WallChain& chain, const effects::State& start) {
  const geometry::Bounds& box = start.outline.bounds();
  const double farthest = std::hypot(box.x1 - box.x0, box.y1 - box.y0);
  Wall wall;
  for (const geometry::WallPiece& piece : chain.pieces) {
    if (piece.radius > 0) wall.thrombi.push_back({piece.centre, piece.radius});
    const double dx = piece.to[0] - piece.from[0], dy = piece.to[1] - piece.from[1];
    const double length = std::hypot(dx, dy);
    const int count = std::max(1, static_cast<int>(std::lround(length / (station_distance * start.spacing))));
    for (int k = 0; k < count; ++k) {
      const double part = (k + 0.5) / count;
      Station at{
          piece.from[0] + part * dx, piece.from[1] + part * dy, -dy / length, dx / length, 0, length / count};
      const auto across =
          fluid_segments(start, {at.x, at.y}, {at.x + farthest * at.nx, at.y + farthest * at.ny});
      if (across.empty()) continue;
      at.reach = std::hypot(across.front().to[0] - at.x, across.front().to[1] - at.y);
      wall.stations.push_back(at);
    }
  }
  return wall;
}

double FreeLayers::distance(const Wall& wall, const Station& from, double way, const effects::State& state) {
  double least = way;
  for (const geometry::Bump& thrombus : wall.thrombi) {
    const double dx = from.x + way * from.nx - thrombus.centre[0];
    const double dy = from.y + way * from.ny - thrombus.centre[1];
    least = std::min(least, std::hypot(dx - state.periods_x(dx), dy) - thrombus.radius);
  }
  return least;
}

std::array<FreeLayer, 2> FreeLayers::measure(const effects::State& state) const {
  const std::vector<Target> targets = targets_in(state);
  std::array<FreeLayer, 2> layers;
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    double sum = 0, length = 0, least = infinity;
    for (const Station& at : walls_[w].stations) {
      double way = infinity;
      for (const Target& target : targets) way = std::min(way, way_to(target, at.x, at.y, at.nx, at.ny));
      if (way > at.reach) continue;
      const double layer = distance(walls_[w], at, way, state);
      sum += layer * at.length;
      length += at.length;
      least = std::min(least, layer);
    }
    layers[w] = {length > 0 ? sum / length : none, least};
  }
  return layers;
}

const ObserverKind cell_free_layer{
    "cell_free_layer",
    true,
    [](const Case& scene) {
      if (scene.vessel.shape == Shape::box)
        return effects::Need{false, "a box has no lower and upper wall along the flow", "/vessel/shape"};
      return effects::on_request(effects::needs_cells(scene, "cells keep away from the walls"),
                                 "the case does not ask for the cell-free layer");
    },
    [](const effects::State& start, const CellFreeFlow&) -> std::unique_ptr<Observer> {
      return std::make_unique<CellFreeLayer>(start);
    },
    [](const Case&) {
      return std::vector<Column>{{"cell_free_layer.lower", "m"}, {"cell_free_layer.upper", "m"}};
    },
    {},
    {.step = {.membrane_node = 30}}};

}  // namespace rouleau::observe
