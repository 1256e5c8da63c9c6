#include "engine/observe/fahraeus.h"

#include <cmath>
#include <limits>

#include "engine/cells/ring.h"
#include "engine/cells/shape.h"
#include "engine/observe/fluid_segments.h"

namespace rouleau::observe {

namespace {

// In own units: less flow is none.
constexpr double no_flux = 1e-9;

class Fahraeus : public Observer {
 public:
  explicit Fahraeus(const effects::State& start)
      : planes_(flow_planes(start)), diameter_(start.scene.vessel.diameter) {}

  void follow(const effects::State& state) override {
    const CellFlux flux = cell_flux(state, planes_);
    time_ += state.dt;
    sum_.all += state.dt * flux.all;
    sum_.cells += state.dt * flux.cells;
    sum_.tube_hematocrit += state.dt * flux.tube_hematocrit;
  }

  void sample(const effects::State& state, Row& row) override {
    const Hematocrit now = hematocrit(cell_flux(state, planes_));
    row.values.insert(row.values.end(), {now.tube, now.discharge, now.ratio()});
  }

  void report(RunSummary& summary) const override {
    if (time_ <= 0) return;
    const Hematocrit mean = hematocrit({sum_.all / time_, sum_.cells / time_, sum_.tube_hematocrit / time_});
    summary.findings.push_back({"fahraeus.tube_hematocrit", mean.tube, "1"});
    summary.findings.push_back({"fahraeus.discharge_hematocrit", mean.discharge, "1"});
    summary.findings.push_back({"fahraeus.ratio", mean.ratio(), "1"});
    summary.findings.push_back(
        {"fahraeus.ratio_of_tubes", fahraeus_ratio_of_tubes(diameter_, mean.discharge), "1"});
  }

  void save(ByteWriter& bytes) override { bytes(time_, sum_.all, sum_.cells, sum_.tube_hematocrit); }
  void restore(ByteReader& bytes) override { bytes(time_, sum_.all, sum_.cells, sum_.tube_hematocrit); }

 private:
  FlowPlanes planes_;
  double diameter_;
  double time_ = 0;
  CellFlux sum_;  ///< over time
};

/// Whether something drives the plasma along a periodic vessel.
bool is_driven(const Case& scene) {
  const WallVelocity& walls = scene.vessel.wall_velocity;
  return scene.body_acceleration[0] != 0 || walls.lower + walls.upper != 0;
}

}  // namespace

CellFlux cell_flux(const effects::State& state, const FlowPlanes& planes) {
  CellFlux flux;
  flux.all = total_flux(state.particles, planes.inlet);
  for (const effects::CellState& cell : state.cells) {
    if (cell.departure) continue;
    const auto nodes = static_cast<std::size_t>(cell.nodes);
    const cells::Ring ring = state.ring(cell);
    const double area = cells::area(ring);
    const auto velocity = cells::centroid_velocity(ring, {&state.particles.u[cell.first_node], nodes},
                                                   {&state.particles.v[cell.first_node], nodes});
    flux.cells += area * velocity[0] / state.outline.length();
    flux.tube_hematocrit += area / state.outline.area();
  }
  return flux;
}

Hematocrit hematocrit(const CellFlux& flux) {
  const double discharge =
      std::abs(flux.all) > no_flux ? flux.cells / flux.all : std::numeric_limits<double>::quiet_NaN();
  return {flux.tube_hematocrit, discharge};
}

double fahraeus_ratio_of_tubes(double diameter, double discharge_hematocrit) {
  const double d = diameter * 1e6;
  const double dilute = 1 + 1.7 * std::exp(-0.415 * d) - 0.6 * std::exp(-0.011 * d);
  return discharge_hematocrit + (1 - discharge_hematocrit) * dilute;
}

const ObserverKind fahraeus{
    "fahraeus",
    true,
    [](const Case& scene) {
      if (scene.vessel.shape != Shape::straight)
        return effects::Need{false, "only a straight vessel has one flow that cells are carried by",
                             "/vessel/shape"};
      if (!is_open(scene.vessel) && !is_driven(scene))
        return effects::Need{false, "nothing drives the plasma along the vessel", "/body_acceleration"};
      return effects::on_request(effects::needs_cells(scene, "cells are faster than the plasma"),
                                 "the case does not ask for the Fahraeus ratio");
    },
    [](const effects::State& start, const CellFreeFlow&) -> std::unique_ptr<Observer> {
      return std::make_unique<Fahraeus>(start);
    },
    [](const Case&) {
      return std::vector<Column>{
          {"fahraeus.tube_hematocrit", "1"}, {"fahraeus.discharge_hematocrit", "1"}, {"fahraeus.ratio", "1"}};
    },
    {},
    {.step = {.particle = 1}}};

}  // namespace rouleau::observe
