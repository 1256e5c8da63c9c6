#include "tests/stability/watcher.h"

#include <algorithm>
#include <cmath>

#include "engine/cells/shape.h"

namespace rouleau::stability {

namespace {

struct Box {
  double x0 = 1e300, y0 = 1e300, x1 = -1e300, y1 = -1e300;

  void add(double x, double y) {
    x0 = std::min(x0, x);
    y0 = std::min(y0, y);
    x1 = std::max(x1, x);
    y1 = std::max(y1, y);
  }
  bool contains(double x, double y) const { return x >= x0 && x <= x1 && y >= y0 && y <= y1; }
};

Box box_of(cells::Ring ring) {
  Box box;
  for (std::size_t q = 0; q < ring.size(); ++q) box.add(ring.x[q], ring.y[q]);
  return box;
}

struct Edge {
  double ax, ay, bx, by;
  int a, b;  ///< its nodes among the particles
};

double cross(double ax, double ay, double bx, double by) {
  return ax * by - ay * bx;
}

/// Whether two edges cross in their interiors; neighbours along a membrane share a node and do not count.
bool crosses(const Edge& e, const Edge& f) {
  if (e.a == f.a || e.a == f.b || e.b == f.a || e.b == f.b) return false;
  const double ex = e.bx - e.ax, ey = e.by - e.ay, fx = f.bx - f.ax, fy = f.by - f.ay;
  const double f_a = cross(ex, ey, f.ax - e.ax, f.ay - e.ay), f_b = cross(ex, ey, f.bx - e.ax, f.by - e.ay);
  const double e_a = cross(fx, fy, e.ax - f.ax, e.ay - f.ay), e_b = cross(fx, fy, e.bx - f.ax, e.by - f.ay);
  return f_a * f_b < 0 && e_a * e_b < 0;
}

/// From left to right, so that those that overlap along x are neighbours.
std::vector<Edge> edges_of(const effects::State& state) {
  std::vector<Edge> edges;
  const auto& p = state.particles;
  for (const effects::CellState& cell : state.cells) {
    for (int q = 0; q < cell.nodes; ++q) {
      const int a = cell.first_node + q, b = cell.first_node + (q + 1) % cell.nodes;
      edges.push_back({p.x[a], p.y[a], p.x[b], p.y[b], a, b});
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& e, const Edge& f) { return std::min(e.ax, e.bx) < std::min(f.ax, f.bx); });
  return edges;
}

}  // namespace

Watcher::Watcher()
    : worst_{{"not_finite", {.bound = 0}},
             {"crossing_edges", {.bound = 0}},
             {"wrong_side", {.bound = 0}},
             {"area", {.bound = 0.005}},
             {"divergence", {.bound = 0.01}}} {}

void Watcher::look(const effects::State& state) {
  look_at_values(state);
  if (worst_.at("not_finite").value > 0) return;
  look_at_sides(state);
  look_at_edges(state);
  look_at_areas(state);
  look_at_divergence(state);
}

void Watcher::note(const effects::State& state, const char* name, double value, double x, double y) {
  Worst& worst = worst_.at(name);
  if (!(value > worst.value)) return;
  const double length = state.scales.length;
  worst = {value, worst.bound, state.time * state.scales.time(), x * length, y * length};
}

void Watcher::look_at_values(const effects::State& state) {
  const auto& p = state.particles;
  int bad = 0, first = 0;
  for (int i = 0; i < p.active_end(); ++i) {
    if (std::isfinite(p.x[i] + p.y[i] + p.u[i] + p.v[i] + p.p[i])) continue;
    if (bad++ == 0) first = i;
  }
  note(state, "not_finite", bad, p.x[first], p.y[first]);
}

void Watcher::look_at_sides(const effects::State& state) {
  const auto& p = state.particles;
  std::vector<Box> boxes;
  for (const effects::CellState& cell : state.cells) boxes.push_back(box_of(state.ring(cell)));
  int wrong = 0, first = 0;
  for (int i = 0; i < p.active_end(); ++i) {
    bool at_home = state.outline.distance(p.x[i], p.y[i]).value >= 0;
    for (std::size_t c = 0; c < boxes.size() && at_home; ++c) {
      const bool belongs = p.cell[i] == static_cast<int>(c);
      if (belongs && i < p.membrane_end()) continue;
      const bool inside =
          boxes[c].contains(p.x[i], p.y[i]) && cells::contains(state.ring(state.cells[c]), p.x[i], p.y[i]);
      at_home = inside == belongs;
    }
    if (!at_home && wrong++ == 0) first = i;
  }
  note(state, "wrong_side", wrong, p.x[first], p.y[first]);
}

void Watcher::look_at_edges(const effects::State& state) {
  const std::vector<Edge> edges = edges_of(state);
  int crossing = 0;
  Edge first{};
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Edge& e = edges[i];
    const double right = std::max(e.ax, e.bx);
    for (std::size_t j = i + 1; j < edges.size() && std::min(edges[j].ax, edges[j].bx) <= right; ++j) {
      if (crosses(e, edges[j]) && crossing++ == 0) first = e;
    }
  }
  note(state, "crossing_edges", crossing, first.ax, first.ay);
}

void Watcher::look_at_areas(const effects::State& state) {
  for (const effects::CellState& cell : state.cells) {
    if (cell.nodes == 0) continue;
    const cells::Shape shape = cells::measure(state.ring(cell));
    note(state, "area", std::abs(shape.area / cell.start_area - 1), shape.x, shape.y);
  }
}

void Watcher::look_at_divergence(const effects::State& state) {
  const auto& p = state.particles;
  operators::interleave(p.u, p.v, velocity_);
  state.operators.divergences(velocity_.data(), divergence_);
  // In a box with a moving lid the source holds what the fits make of the singular flow in its corners.
  const bool lid = state.scene.vessel.ends == Ends::closed;
  for (int i = 0; i < p.active_end(); ++i) {
    const double divergence = divergence_[i] - (lid ? state.source[i] : 0);
    note(state, "divergence", std::abs(divergence) * state.spacing, p.x[i], p.y[i]);
  }
}

Centroid centroid_of(const effects::State& state, std::size_t cell) {
  const cells::Shape shape = cells::measure(state.ring(state.cells[cell]));
  return {shape.x * state.scales.length, shape.y * state.scales.length};
}

}  // namespace rouleau::stability
