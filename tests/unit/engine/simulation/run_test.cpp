#include "engine/simulation/run.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/case/case_error.h"
#include "engine/case/presets.h"
#include "engine/simulation/run_failure.h"
#include "tests/unit/engine/simulation/recorder.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau {
namespace {

TEST(Run, EndsAfterTheWholeDuration) {
  Recorder recorder;
  const Case scene = coarse_vessel();
  const RunSummary summary = run_case(scene, recorder);
  EXPECT_EQ(summary.ending, Ending::completed);
  EXPECT_FALSE(summary.reason.empty());
  EXPECT_GE(summary.steps, recorder.header.plan.steps);
  EXPECT_NEAR(summary.simulated_time, scene.duration, 1e-6 * scene.duration);
  EXPECT_GE(summary.poiseuille_deviation, 0);
  EXPECT_TRUE(summary.cells.empty());
}

TEST(Run, TwoRunsGiveTheSameBits) {
  Recorder one, other;
  const Case scene = coarse_vessel_with_cells();
  run_case(scene, one);
  run_case(scene, other);
  ASSERT_EQ(one.rows.size(), 11u);
  EXPECT_EQ(one.rows, other.rows);
  ASSERT_EQ(one.frames.size(), other.frames.size());
  for (std::size_t k = 0; k < one.frames.size(); ++k) {
    EXPECT_EQ(one.frames[k].id, other.frames[k].id);
    EXPECT_EQ(one.frames[k].x, other.frames[k].x);
    EXPECT_EQ(one.frames[k].p, other.frames[k].p);
  }
}

TEST(Run, LookingAtItMoreOftenDoesNotChangeIt) {
  Recorder often, seldom;
  Case scene = coarse_vessel_with_cells();
  run_case(scene, often);
  scene.output = {2e-4, 0};
  run_case(scene, seldom);
  ASSERT_EQ(seldom.rows.size(), 3u);
  EXPECT_EQ(seldom.rows.back(), often.rows.back());
  EXPECT_TRUE(seldom.frames.empty());
}

TEST(Run, WhatASceneDoesNotCallForMakesNoDifferenceSwitchedOff) {
  Recorder automatic, off;
  Case scene = coarse_vessel();
  run_case(scene, automatic);
  for (const char* name : {"stretch", "bending", "contact", "area_control", "membrane_clearance"}) {
    scene.effects[name] = Switch::off;
  }
  run_case(scene, off);
  EXPECT_EQ(automatic.rows, off.rows);
}

TEST(Run, SeriesAndFramesComeAtTheirIntervalsFromTheStartOn) {
  Recorder recorder;
  const Case scene = coarse_vessel();
  run_case(scene, recorder);
  const double step = recorder.header.plan.time_step;
  ASSERT_EQ(recorder.rows.size(), 11u);
  for (std::size_t k = 0; k < recorder.rows.size(); ++k) {
    const double due = scene.output.series_interval * static_cast<double>(k);
    EXPECT_GE(recorder.rows[k][0], due * (1 - 1e-6));
    EXPECT_LT(recorder.rows[k][0], due + 1.001 * step);
  }
  ASSERT_EQ(recorder.frames.size(), 5u);
  for (std::size_t k = 0; k < recorder.frames.size(); ++k) {
    const double due = scene.output.frame_interval * static_cast<double>(k);
    EXPECT_GE(recorder.frames[k].time, due * (1 - 1e-6));
    EXPECT_LT(recorder.frames[k].time, due + 1.001 * step);
  }
}

TEST(Run, TheStopTokenEndsItBetweenTwoSteps) {
  struct Stopping : Recorder {
    std::stop_source source;
    void series_row(std::span<const double> row) override {
      Recorder::series_row(row);
      if (rows.size() == 4) source.request_stop();
    }
  } recorder;
  const RunSummary summary = run_case(coarse_vessel(), recorder, recorder.source.get_token());
  EXPECT_EQ(summary.ending, Ending::stopped);
  EXPECT_EQ(recorder.rows.size(), 4u);
  EXPECT_DOUBLE_EQ(summary.simulated_time, recorder.rows.back()[0]);
  EXPECT_LT(summary.simulated_time, coarse_vessel().duration / 2);
}

TEST(Run, ACellCarriedBackToTheInletEndsIt) {
  Recorder recorder;
  Case scene = coarse_vessel_with_cells();
  scene.inflow.waveform = {{0, -1}};
  scene.duration = 5e-3;
  const RunSummary summary = run_case(scene, recorder);
  EXPECT_EQ(summary.ending, Ending::cell_reached_inlet);
  EXPECT_GT(summary.steps, 3);
  EXPECT_LT(summary.simulated_time, 2e-3);
  EXPECT_LT(recorder.told.back().fraction, 1);
}

TEST(Run, OneThatGoesUnstableTellsWhatItCameTo) {
  Case scene = coarse_vessel();
  scene.numerics = preset_numerics(Preset::paper);
  scene.numerics.spacing = 1e-6;
  scene.effects = {{"density_source_relaxation", Switch::off},
                   {"wall_end_exclusion", Switch::off},
                   {"gradient_from_least_pressure", Switch::off}};
  Recorder recorder;
  try {
    run_case(scene, recorder);
    FAIL() << "went on";
  } catch (const RunFailure& failure) {
    EXPECT_EQ(failure.breach().quantity, "speed");
    EXPECT_GE(failure.breach().particle, 0);
    EXPECT_EQ(failure.summary().ending, Ending::failed);
    EXPECT_EQ(to_json(failure.summary()).at("ending"), "failed");
    EXPECT_EQ(failure.summary().steps, failure.breach().step - 1);
    EXPECT_EQ(recorder.rows.size(), 1 + static_cast<std::size_t>(failure.summary().simulated_time / 4e-5));
    for (const double value : recorder.rows.back()) EXPECT_TRUE(std::isfinite(value));
  }
}

TEST(Run, TheSummaryHasTheWorstOfWhatIsWatched) {
  Recorder recorder;
  Case scene = coarse_vessel_with_cells();
  scene.cells[0].fill = 0.5;
  scene.duration = 1e-4;
  const RunSummary summary = run_case(scene, recorder);
  std::map<std::string, WatchedQuantity> watched;
  for (const WatchedQuantity& quantity : summary.watched) watched[quantity.name] = quantity;
  for (const char* most : {"speed", "divergence", "change of area", "greatest perimeter"}) {
    EXPECT_GT(watched.at(most).worst, 0) << most;
    EXPECT_LT(watched.at(most).worst, watched.at(most).bound) << most;
  }
  EXPECT_LT(watched.at("divergence").worst, 0.2);
  EXPECT_DOUBLE_EQ(watched.at("speed").worst, summary.peak_fluid_speed);
  EXPECT_NEAR(watched.at("change of area").worst, summary.cells[0].area_deviation, 1e-12);
  // A cell is thinner than two of these coarse spacings.
  EXPECT_LT(watched.at("thickness").worst, 2);
  ASSERT_EQ(summary.warnings.size(), 1u);
  EXPECT_NE(summary.warnings[0].find("cell 0"), std::string::npos);
  const auto& shares = summary.cells[0].time_as;
  EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1, 1e-12);
  EXPECT_EQ(to_json(summary).at("watched").at("speed").at("unit"), "m/s");
}

TEST(Run, ProgressNeverFallsBackAndEndsAtOne) {
  Recorder recorder;
  Case scene = coarse_vessel_with_cells();
  scene.duration = 1e-3;
  scene.cells[0].x = 6e-6;
  scene.vessel.length = 40e-6;
  run_case(scene, recorder);
  ASSERT_FALSE(recorder.told.empty());
  EXPECT_TRUE(std::is_sorted(recorder.told.begin(), recorder.told.end(),
                             [](const Progress& a, const Progress& b) { return a.steps < b.steps; }));
  for (const Progress& p : recorder.told) {
    EXPECT_EQ(p.duration, scene.duration);
    EXPECT_NEAR(p.fraction, p.simulated_time / p.duration, 1e-9);
    EXPECT_GE(p.eta_s, 0);
  }
  EXPECT_NEAR(recorder.told.back().fraction, 1, 1e-6);
}

TEST(Run, ACaseThatCannotBePlannedDoesNotBegin) {
  struct Untouched : Output {
    void begin(const RunHeader&) override { ADD_FAILURE() << "the run began"; }
  } output;
  Case scene = coarse_vessel();
  scene.effects["bending"] = Switch::on;
  EXPECT_THROW(run_case(scene, output), CaseError);
}

TEST(Run, SummaryAsJsonTellsTheEnding) {
  RunSummary summary;
  summary.ending = Ending::cell_reached_inlet;
  summary.cells.resize(2);
  const nlohmann::json json = to_json(summary);
  EXPECT_EQ(json.at("ending"), "cell_reached_inlet");
  EXPECT_EQ(json.at("cells").size(), 2u);
  EXPECT_FALSE(json.contains("poiseuille_deviation"));
}

TEST(Run, SaysHowOftenEachEffectWasAwake) {
  Case scene = coarse_vessel_with_cells();
  scene.vessel.ends = Ends::periodic;  // at rest: nothing has to settle, and no step is taken again
  Recorder recorder;
  const RunSummary summary = run_case(scene, recorder);
  ASSERT_EQ(summary.rejected_steps, 0);
  std::map<std::string, EffectTime> by_name;
  for (const EffectTime& time : summary.effect_times) by_name[time.name] = time;
  for (const auto& [name, time] : by_name) {
    EXPECT_LE(time.awake, time.rounds) << name;
    EXPECT_GE(time.rounds, summary.steps) << name;
  }
  EXPECT_GE(by_name.at("contact").awake, summary.contact_steps);
  EXPECT_EQ(by_name.at("contact").awake, 0);
  EXPECT_EQ(by_name.at("bending").awake, summary.steps);
  EXPECT_EQ(by_name.at("stretch").rounds, by_name.at("bending").rounds);
  EXPECT_FALSE(by_name.contains("viscosity_contrast"));
}

TEST(Run, TimesOfTheEffectsAddUpToLessThanTheWallTime) {
  Recorder recorder;
  const RunSummary summary = run_case(coarse_vessel(), recorder);
  double sum = 0;
  for (const EffectTime& time : summary.effect_times) {
    EXPECT_GE(time.seconds, 0);
    sum += time.seconds;
  }
  EXPECT_GT(sum, 0);
  EXPECT_LE(sum, summary.wall_time);
}

}  // namespace
}  // namespace rouleau
