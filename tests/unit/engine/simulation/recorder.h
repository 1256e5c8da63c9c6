#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "engine/simulation/run.h"

namespace rouleau {

/// Keeps all that a run delivers.
struct Recorder : Output {
  RunHeader header;
  std::vector<std::vector<double>> rows;
  std::vector<double> probe_times;
  std::vector<std::vector<ProbeValues>> probe_rows;
  std::vector<Frame> frames;
  std::vector<Progress> told;

  void begin(const RunHeader& given) override { header = given; }
  void series_row(std::span<const double> row) override { rows.emplace_back(row.begin(), row.end()); }
  void probe_row(double time, std::span<const ProbeValues> row) override {
    probe_times.push_back(time);
    probe_rows.emplace_back(row.begin(), row.end());
  }
  void frame(const Frame& frame) override { frames.push_back(frame); }
  void progress(const Progress& progress) override { told.push_back(progress); }
};

/// A summary without what depends on the machine's speed.
inline nlohmann::json timeless(nlohmann::json summary) {
  for (const char* name : {"wall_time", "steps_per_second", "effect_times"}) summary.erase(name);
  return summary;
}

}  // namespace rouleau
