#include "service/sweep/sweep_table.h"

#include <cmath>
#include <gmock/gmock.h>

#include <gtest/gtest.h>

#include "service/sweep/sweep_picture.h"

namespace rouleau::service {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;

const json summary = json::parse(R"({
  "wall_time": 1.5, "peak_fluid_speed": 0.01,
  "cells": [{"peak_velocity": 0.006, "peak_tau": 0.4, "least_tau": 0.1, "departure": {"time": 0.0125}},
            {"peak_velocity": 0.005, "peak_tau": 0.3, "least_tau": 0.2, "departure": null}]})");

TEST(SweepTable, HasARowAPointWithWhatItCameTo) {
  const SweepTable table = make_table(
      {"/duration"}, {{0, "", "ab", {0.1}, "succeeded", summary}, {1, "", "cd", {0.2}, "failed", {}}});
  std::vector<std::string> names;
  for (const Column& column : table.columns) names.push_back(column.name);
  EXPECT_THAT(
      names, ElementsAre("index", "case_hash", "/duration", "state", "wall_time", "peak_fluid_speed",
                         "cell0.peak_velocity", "cell0.peak_tau", "cell0.least_tau", "cell0.residence_time",
                         "cell1.peak_velocity", "cell1.peak_tau", "cell1.least_tau", "cell1.residence_time"));
  EXPECT_THAT(table.rows[0], ElementsAre(0u, "ab", 0.1, "succeeded", 1.5, 0.01, 0.006, 0.4, 0.1, 0.0125,
                                         0.005, 0.3, 0.2, nullptr));
  EXPECT_EQ(table.rows[1].size(), names.size());
  EXPECT_EQ(table.rows[1][3], "failed");
  EXPECT_EQ(table.rows[1][9], nullptr);
  const json body = to_json(table);
  EXPECT_EQ(body["units"]["cell0.residence_time"], "s");
  EXPECT_FALSE(body["units"].contains("/duration"));
  EXPECT_EQ(to_json(read_table(body)), body);
}

TEST(SweepTable, CsvQuotesWhatNeedsIt) {
  const SweepTable table =
      make_table({"/name", "/waveform"}, {{0, "id", "ab", {"a,\"b\"\n", {1, 2}}, "queued", {}}});
  EXPECT_EQ(to_csv(table),
            "index,job,case_hash,/name,/waveform,state,wall_time,peak_fluid_speed\n"
            "0,id,ab,\"a,\"\"b\"\"\n\",\"[1,2]\",queued,,\n");
}

std::vector<SweepRow> rows_of(const std::vector<std::vector<json>>& values) {
  std::vector<SweepRow> rows;
  for (const auto& point : values) rows.push_back({rows.size(), "", "ab", point, "succeeded", summary});
  return rows;
}

TEST(SweepPicture, HasALineForEachValueOfTheSecondAxis) {
  const auto table = make_table({"/a<b", "/c"}, rows_of({{1, 5}, {1, 6}, {2, 5}, {2, 6}, {3, "x"}}));
  const std::string svg = draw_sweep(table, 2);
  EXPECT_THAT(svg, ::testing::StartsWith("<svg "));
  EXPECT_THAT(svg, ::testing::HasSubstr("/a&lt;b"));
  EXPECT_THAT(svg, ::testing::HasSubstr("/c = 6"));
  EXPECT_THAT(svg, ::testing::Not(::testing::HasSubstr("nan")));
}

TEST(SweepPicture, OfValuesThatHardlyDifferHasAnEnd) {
  for (const double value : {0.005, 1.0, 3e-7, 1e300}) {
    auto rows = rows_of({{1}, {2}});
    rows[1].summary["cells"][0]["peak_velocity"] = value;
    rows[0].summary["cells"][0]["peak_velocity"] = std::nextafter(std::nextafter(value, HUGE_VAL), HUGE_VAL);
    EXPECT_LT(draw_sweep(make_table({"/a"}, rows), 1).size(), 10000u);
  }
}

TEST(SweepPicture, IsNotDrawnWhereItWouldShowNothing) {
  EXPECT_EQ(draw_sweep(make_table({"/a"}, rows_of({{1}})), 1), "");
  EXPECT_EQ(draw_sweep(make_table({"/a"}, rows_of({{"x"}, {"y"}})), 1), "");
  EXPECT_EQ(draw_sweep(make_table({"/a", "/b", "/c"}, rows_of({{1, 2, 3}, {2, 2, 3}})), 3), "");
  EXPECT_EQ(
      draw_sweep(make_table({"/a"}, {{0, "", "ab", {1}, "failed", {}}, {1, "", "ab", {2}, "failed", {}}}), 1),
      "");
}

}  // namespace
}  // namespace rouleau::service
