#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/simulation/run.h"

namespace rouleau::validation {

/// Keeps everything that a run delivers.
class RecordedRun : public Output {
 public:
  explicit RecordedRun(const Case& scene) { summary = run_case(scene, *this); }

  void begin(const RunHeader& given) override { header = given; }
  void series_row(std::span<const double> row) override { rows.emplace_back(row.begin(), row.end()); }
  void probe_row(double, std::span<const ProbeValues> row) override { probes.assign(row.begin(), row.end()); }
  void frame(const Frame& frame) override { frames.push_back(frame); }

  std::vector<double> column(const std::string& name) const {
    for (std::size_t c = 0; c < header.columns.size(); ++c) {
      if (header.columns[c].name != name) continue;
      std::vector<double> values;
      for (const auto& row : rows) values.push_back(row[c]);
      return values;
    }
    ADD_FAILURE() << "no column " << name;
    return {};
  }

  /// Linear interpolation of one column where another one passes a value for the first time.
  double where(const std::string& name, double value, const std::string& wanted) const {
    const auto at = column(name);
    const auto of = column(wanted);
    for (std::size_t k = 1; k < at.size(); ++k) {
      if (at[k - 1] <= value && at[k] > value) {
        const double s = (value - at[k - 1]) / (at[k] - at[k - 1]);
        return of[k - 1] + s * (of[k] - of[k - 1]);
      }
    }
    ADD_FAILURE() << name << " never passes " << value;
    return std::nan("");
  }

  RunHeader header;
  RunSummary summary;
  std::vector<std::vector<double>> rows;
  std::vector<ProbeValues> probes;  ///< their last row
  std::vector<Frame> frames;
};

/// The study's straight vessel (section 2.4): 80 x 10 um, plasma, 5 mm/s, d0 = 0.4 um.
inline Case study_vessel(double duration) {
  Case scene;
  scene.vessel = {80e-6, 10e-6};
  scene.duration = duration;
  return scene;
}

}  // namespace rouleau::validation
