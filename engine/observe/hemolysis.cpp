#include "engine/observe/hemolysis.h"

#include <algorithm>
#include <cmath>

#include "engine/case/wording.h"
#include "engine/observe/cell_columns.h"
#include "engine/observe/plasma_stress.h"

namespace rouleau::observe {

namespace {

const std::vector<Column> cell_columns{{"scalar_shear_stress", "Pa"}, {"hemolysis", "1"}};

/// What a cell went through. SI.
struct Exposure {
  double dose = 0;
  double time = 0;             ///< s
  double greatest_stress = 0;  ///< Pa
};

template <class Stream>
void visit(Stream& stream, Exposure& exposure) {
  auto& [dose, time, greatest_stress] = exposure;
  stream(dose, time, greatest_stress);
}

double stress_in_pascal(const effects::State& state, std::size_t k) {
  return scalar_shear_stress(state, state.cells[k]) * state.scales.pressure();
}

std::string warning(double stress, double time) {
  return "hemolysis: its power laws were fitted to stresses of 40 to 700 Pa (the default's to 57 to 255 Pa, "
         "held "
         "for 7 to 700 ms); here a cell felt " +
         rounded(stress, "Pa") + " at most, in " + rounded(time, "s") +
         ". Flows in such vessels lie far below that calibration: compare runs by the index, do not take it "
         "for damage";
}

class Hemolysis : public Observer {
 public:
  explicit Hemolysis(const effects::State& state)
      : law_(hemolysis_law(state.scene)), exposures_(state.cells.size()) {}

  void follow(const effects::State& state) override {
    const double time = state.dt * state.scales.time();
    for (std::size_t k = 0; k < exposures_.size(); ++k) {
      if (state.cells[k].departure) continue;
      const double stress = stress_in_pascal(state, k);
      Exposure& exposure = exposures_[k];
      exposure.dose += law_.dose(stress, time);
      exposure.time += time;
      exposure.greatest_stress = std::max(exposure.greatest_stress, stress);
    }
  }

  void sample(const effects::State& state, Row& row) override {
    append_of_cells(state, cell_columns.size(), row.values, [&](std::size_t k) {
      return std::vector{stress_in_pascal(state, k), law_.index(exposures_[k].dose)};
    });
  }

  void report(RunSummary& summary) const override {
    double stress = 0, time = 0;
    for (std::size_t k = 0; k < exposures_.size(); ++k) {
      const std::string cell = cell_name(k);
      summary.findings.push_back({cell + "hemolysis", law_.index(exposures_[k].dose), "1"});
      summary.findings.push_back(
          {cell + "scalar_shear_stress_greatest", exposures_[k].greatest_stress, "Pa"});
      stress = std::max(stress, exposures_[k].greatest_stress);
      time = std::max(time, exposures_[k].time);
    }
    summary.warnings.push_back(warning(stress, time));
  }

  void save(ByteWriter& bytes) override { bytes(exposures_); }
  void restore(ByteReader& bytes) override { restore_of_cells(bytes, exposures_); }

 private:
  HemolysisLaw law_;
  std::vector<Exposure> exposures_;  ///< [cells]
};

}  // namespace

double HemolysisLaw::dose(double stress, double time) const {
  return std::pow(stress, stress_exponent / time_exponent) * time;
}

double HemolysisLaw::index(double dose) const {
  return factor * std::pow(dose, time_exponent);
}

HemolysisLaw hemolysis_law(const Case& scene) {
  const auto constant = [&](const char* name) { return effects::parameter(scene, hemolysis, name); };
  return {constant("factor"), constant("stress_exponent"), constant("time_exponent")};
}

const ObserverKind hemolysis{
    "hemolysis",
    true,
    [](const Case& scene) {
      return effects::on_request(effects::needs_cells(scene, "cells are under stress"),
                                 "the case does not ask for the hemolysis index");
    },
    [](const effects::State& start, const CellFreeFlow&) -> std::unique_ptr<Observer> {
      return std::make_unique<Hemolysis>(start);
    },
    [](const Case& scene) { return columns_of_cells(scene, cell_columns); },
    {{"factor", "1", "C of the law: the index, a fraction, after 1 s at 1 Pa", 3.62e-7, 0, 1},
     {"stress_exponent", "1", "alpha of the law", 2.416, 0.1, 10},
     {"time_exponent", "1", "beta of the law", 0.785, 0.1, 10}},
    {.step = {.membrane_node = 300}}};

}  // namespace rouleau::observe
