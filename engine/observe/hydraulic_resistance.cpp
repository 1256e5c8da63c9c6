#include "engine/observe/hydraulic_resistance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/cells/shape.h"
#include "engine/observe/cell_columns.h"
#include "engine/observe/flow_planes.h"
#include "engine/observe/fluid_segments.h"

namespace rouleau::observe {

namespace {

using effects::Need;
using effects::State;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
// Over the unit of flux: where a flow turns round its pressure drop does not follow from it.
constexpr double no_flux = 1e-2;

const std::vector<Column> cell_columns{{"resistance", "Pa s/m2"}};

/// [nodes][2]: at the end of the step, as the fluid felt them, with what stiffness made of the motion.
std::vector<double> forces_of_nodes(const State& state) {
  const auto& particles = state.particles;
  std::vector<double> force;
  for (std::size_t i = 0; i < state.load.fx.size(); ++i) {
    force.insert(force.end(), {state.load.fx[i], state.load.fy[i]});
  }
  for (const cells::Stiffness& element : state.load.stiffness) {
    double along = 0;
    for (std::size_t q = 0; q < 3; ++q) {
      const int node = element.node[q];
      along += element.g[2 * q] * particles.u[node] + element.g[2 * q + 1] * particles.v[node];
    }
    for (std::size_t q = 0; q < 3; ++q) {
      const auto node = static_cast<std::size_t>(element.node[q]);
      force[2 * node] -= element.k * along * state.dt * element.g[2 * q];
      force[2 * node + 1] -= element.k * along * state.dt * element.g[2 * q + 1];
    }
  }
  return force;
}

/// The theorem's second term.
double by_contrast(const State& state, std::size_t k, const UnitFlow& unit) {
  const effects::CellState& cell = state.cells[k];
  const double contrast = cell.presence * (state.scene.cells[k].viscosity_ratio - 1);
  if (contrast == 0) return 0;
  const cells::Ring ring = state.ring(cell);
  const double* u = &state.particles.u[cell.first_node];
  const double* v = &state.particles.v[cell.first_node];
  // A constant pressure does no work on a cell that keeps its area; the less there is of it, the better.
  const cells::Shape shape = cells::measure(ring);
  const auto middle = unit.stress(shape.x, shape.y);
  const double pressure = -(middle[0] + middle[2]) / 2;
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t before = ring.previous(i), after = ring.next(i);
    const double nx = (ring.y[after] - ring.y[before]) / 2, ny = -(ring.x[after] - ring.x[before]) / 2;
    const auto [xx, xy, yy] = unit.stress(ring.x[i], ring.y[i]);
    sum += u[i] * ((xx + pressure) * nx + xy * ny) + v[i] * (xy * nx + (yy + pressure) * ny);
  }
  return contrast * sum;
}

class HydraulicResistance : public Observer {
 public:
  HydraulicResistance(const State& start, const CellFreeFlow& cell_free)
      : unit_(unit_flow(start, cell_free)),
        planes_(flow_planes(start)),
        si_(start.scales.pressure() / start.scales.flux()) {}

  void follow(const State& state) override {
    const Resistances now = measure_now(state);
    if (std::isnan(now.all)) return;
    time_ += state.dt;
    sum_ += state.dt * now.all;
    sum_unaccounted_ += state.dt * std::abs(now.unaccounted);
    greatest_ = std::max(greatest_, now.all);
  }

  void sample(const State& state, Row& row) override {
    const Resistances now = measure_now(state);
    row.values.insert(row.values.end(), {now.all * si_, unit_->drive() * si_, now.unaccounted * si_});
    append_of_cells(state, cell_columns.size(), row.values,
                    [&](std::size_t k) { return std::vector{now.by_cell[k] * si_}; });
  }

  void report(RunSummary& summary) const override {
    if (time_ <= 0) return;
    const char* unit = "Pa s/m2";
    summary.findings.push_back({"resistance.mean", sum_ / time_ * si_, unit});
    summary.findings.push_back({"resistance.greatest", greatest_ * si_, unit});
    summary.findings.push_back({"resistance_free", unit_->drive() * si_, unit});
    summary.findings.push_back({"resistance_unaccounted.mean", sum_unaccounted_ / time_ * si_, unit});
  }

  void save(ByteWriter& bytes) override { bytes(time_, sum_, sum_unaccounted_, greatest_); }
  void restore(ByteReader& bytes) override { bytes(time_, sum_, sum_unaccounted_, greatest_); }

 private:
  struct Resistances {
    double all = none;
    double unaccounted = none;  ///< what neither the vessel nor the cells explain
    std::vector<double> by_cell;
  };

  Resistances measure_now(const State& state) const {
    const operators::CrossSection inlet = measure(state.particles, planes_.inlet);
    if (std::abs(inlet.flux) < no_flux) return {none, none, std::vector(state.cells.size(), none)};
    Resistances now{drive_of(state, inlet) / inlet.flux, none, pressure_by_cells(state, *unit_)};
    for (double& cell : now.by_cell) cell /= inlet.flux;
    now.unaccounted = now.all - unit_->drive() - std::accumulate(now.by_cell.begin(), now.by_cell.end(), 0.0);
    return now;
  }

  std::unique_ptr<const UnitFlow> unit_;
  FlowPlanes planes_;
  double si_;  ///< Pa s/m2
  double time_ = 0, sum_ = 0, sum_unaccounted_ = 0, greatest_ = 0;
};

Need need_of(const Case& scene) {
  const WallVelocity& walls = scene.vessel.wall_velocity;
  if (scene.vessel.shape == Shape::box) return {false, "a box has no ends", "/vessel/shape"};
  if (walls.lower != 0 || walls.upper != 0)
    return {false, "walls that move drive the plasma, too", "/vessel/wall_velocity"};
  if (!is_open(scene.vessel) && scene.body_acceleration[0] == 0)
    return {false, "nothing drives the plasma along the vessel", "/body_acceleration"};
  if (scene.vessel.shape == Shape::bifurcation && scene.outflow.pressure[0] != scene.outflow.pressure[1])
    return {false, "outlets at different pressures have no common drop", "/outflow/pressure"};
  const Need can{true, "plasma flows through the vessel", "/vessel"};
  return effects::on_request(effects::of_accurate_scheme(scene, can),
                             "the case does not ask for the hydraulic resistance");
}

}  // namespace

std::vector<double> pressure_by_cells(const State& state, const UnitFlow& unit) {
  const std::vector<double> force = forces_of_nodes(state);
  std::vector<double> pressure;
  for (std::size_t k = 0; k < state.cells.size(); ++k) {
    const effects::CellState& cell = state.cells[k];
    double sum = cell.departure ? 0 : by_contrast(state, k, unit);
    for (int node = cell.first_node; node < cell.first_node + cell.nodes; ++node) {
      const auto [u, v] = unit.velocity(state.particles.x[node], state.particles.y[node]);
      const auto n = static_cast<std::size_t>(node);
      sum -= force[2 * n] * u + force[2 * n + 1] * v;
    }
    pressure.push_back(sum);
  }
  return pressure;
}

const ObserverKind hydraulic_resistance{
    "hydraulic_resistance",
    true,
    need_of,
    [](const State& start, const CellFreeFlow& cell_free) -> std::unique_ptr<Observer> {
      return std::make_unique<HydraulicResistance>(start, cell_free);
    },
    [](const Case& scene) {
      std::vector<Column> columns{
          {"resistance", "Pa s/m2"}, {"resistance_free", "Pa s/m2"}, {"resistance_unaccounted", "Pa s/m2"}};
      for (Column& column : columns_of_cells(scene, cell_columns)) columns.push_back(std::move(column));
      return columns;
    },
    {},
    {.start = {.particle = 13000}, .step = {.particle = 5}}};

}  // namespace rouleau::observe
