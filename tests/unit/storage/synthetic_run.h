#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/simulation/output.h"
#include "engine/simulation/run.h"

namespace rouleau::storage {

/// A run that nobody computed: two cells that drift, and plasma of which one particle leaves and one comes
/// with every frame. A probe line reaches out of the fluid, another probe is a single point.
struct SyntheticRun {
  static constexpr int nodes = 12;
  static constexpr int cells = 2;
  static constexpr int plasma = 20;
  static constexpr int wall_nodes = 4;

  static RunHeader header() {
    RunHeader header;
    header.resolved.name = "synthetic";
    header.resolved.vessel = {80e-6, 10e-6};
    header.resolved.duration = 1e-3;
    header.resolved.cells = std::vector<RedCell>(cells);
    header.plan.particles = cells * nodes + plasma;
    header.columns = {{"time", "s"}, {"cell0.x", "m"}, {"particles", "1"}};
    header.resolved.output.fields.push_back(Field::wall_shear_stress);
    header.probes = {{"line", {1e-6, 1e-6, 1e-6}, {-1e-6, 0, 1e-6}, true}, {"point", {2e-6}, {5e-6}, false}};
    header.walls = {{0, 4e-5, 0, 4e-5}, {0, 0, 1e-5, 1e-5}, {0, 0, 0, 0},
                    {1, 1, -1, -1},     {0, 4e-5, 0, 4e-5}, {0, 0, 1, 1}};
    header.membrane_fields = {{"strain", "1"}, {"tension", "N/m"}};
    header.nodes_per_cell = std::vector<int>(cells, nodes);
    header.capacity = cells * nodes + plasma + 5;
    return header;
  }

  static Frame frame(int k) {
    Frame frame;
    frame.time = 1e-4 * k;
    frame.step = 100L * k;
    for (int cell = 0; cell < cells; ++cell) {
      for (int i = 0; i < nodes; ++i) {
        const double angle = 2 * std::numbers::pi * i / nodes;
        add(frame, cell * nodes + i, ParticleKind::membrane, cell,
            1e-5 * (cell + 1) + 1e-6 * k + 2e-6 * std::cos(angle), 5e-6 + 2e-6 * std::sin(angle), k);
      }
    }
    frame.membrane_fields.resize(2);
    for (int i = 0; i < cells * nodes; ++i) {
      frame.membrane_fields[0].push_back(static_cast<float>(0.01 * i + k));
      frame.membrane_fields[1].push_back(static_cast<float>(1e-6 * i));
    }
    for (int i = 0; i < wall_nodes; ++i) frame.wall_shear_stress.push_back(static_cast<float>(k + 0.25 * i));
    for (int i = 0; i < plasma; ++i) {
      add(frame, 1000 + k + i, ParticleKind::plasma, -1, 1e-6 * i, 1e-6, k);
    }
    return frame;
  }

  static std::vector<double> row(int k) { return {2e-5 * k, 1e-6 * k, 44}; }

  static std::vector<ProbeValues> probe_row(int k) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    const double t = k;
    return {{{nothing, 0, 1e-3 * t}, {nothing, 0, -1e-3 * t}, {nothing, 40 - t, 41 - t}, 1e-9 * t},
            {{2e-3 * t}, {0}, {5}, 0}};
  }

  static RunSummary summary() {
    RunSummary summary;
    summary.reason = "the whole duration";
    summary.simulated_time = 1e-3;
    summary.steps = 1000;
    summary.cells.resize(cells);
    return summary;
  }

 private:
  static void add(Frame& frame, int id, ParticleKind kind, int cell, double x, double y, int k) {
    frame.id.push_back(id);
    frame.kind.push_back(kind);
    frame.cell.push_back(cell);
    frame.x.push_back(static_cast<float>(x));
    frame.y.push_back(static_cast<float>(y));
    frame.u.push_back(static_cast<float>(0.005 + 1e-4 * id));
    frame.v.push_back(static_cast<float>(-1e-3 * k));
    frame.p.push_back(static_cast<float>(id));
  }
};

inline const char* const synthetic_case_given = "{\n  \"version\": 1, \"name\": \"\xc3\xa9rythrocyte\"\n}";

/// Delivers `frames` frames with five rows of the series before each.
inline void deliver(Output& output, int frames) {
  output.begin(SyntheticRun::header());
  for (int k = 0; k < frames; ++k) {
    for (int i = 5 * k; i < 5 * k + 5; ++i) {
      output.series_row(SyntheticRun::row(i));
      output.probe_row(SyntheticRun::row(i)[0], SyntheticRun::probe_row(i));
    }
    output.frame(SyntheticRun::frame(k));
  }
}

}  // namespace rouleau::storage
