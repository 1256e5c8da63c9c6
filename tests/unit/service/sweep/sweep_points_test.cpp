#include "service/sweep/sweep_points.h"

#include <gmock/gmock.h>

#include <gtest/gtest.h>

#include "engine/case/case_json.h"
#include "service/http/problem.h"

namespace rouleau::service {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const json scene = json::parse(R"({
  "version": 1, "name": "one cell", "vessel": {"length": 80e-6, "diameter": 10e-6},
  "thrombi": [{"wall": "lower", "x": 40e-6, "radius": 2e-6}],
  "cells": [{"x": 16e-6, "y": 5e-6}], "duration": 1e-3})");

SweepBody sweep_of(const json& axes, const json& more = json::object()) {
  json document{{"case", scene}, {"axes", axes}};
  document.update(more);
  return read_sweep(document, default_most_points, {});
}

std::vector<SweepPoint> points_of(const json& axes, const json& more = json::object()) {
  return expand(sweep_of(axes, more));
}

template <class Work>
Problem problem_of(Work&& work) {
  try {
    work();
  } catch (const Problem& problem) {
    return problem;
  }
  ADD_FAILURE() << "no problem";
  return Problem(problems::internal, "");
}

std::vector<std::string> pointers_of(const Problem& problem) {
  std::vector<std::string> pointers;
  for (const Fault& fault : problem.faults()) pointers.push_back(fault.pointer);
  return pointers;
}

TEST(SweepPoints, AGridVariesTheLastAxisFastest) {
  const auto points =
      points_of({{{"pointer", "/inflow/velocity"}, {"values", {0.001, 0.002}}},
                 {{"pointer", "/thrombi/0/radius"}, {"from", 1e-6}, {"to", 3e-6}, {"count", 3}}});
  ASSERT_EQ(points.size(), 6u);
  EXPECT_EQ(points[1].resolved.inflow.velocity, 0.001);
  EXPECT_EQ(points[1].resolved.thrombi[0].radius, 2e-6);
  EXPECT_EQ(points[5].resolved.inflow.velocity, 0.002);
  EXPECT_EQ(points[5].resolved.thrombi[0].radius, 3e-6);
  EXPECT_THAT(points[5].choice, ElementsAre(1, 2));
}

TEST(SweepPoints, AZipTakesTheValuesTogether) {
  const auto points = points_of({{{"pointer", "/duration"}, {"values", {1e-3, 2e-3}}},
                                 {{"pointer", "/inflow/velocity"}, {"values", {0.001, 0.002}}}},
                                {{"mode", "zip"}});
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[1].resolved.duration, 2e-3);
  EXPECT_EQ(points[1].resolved.inflow.velocity, 0.002);
}

TEST(SweepPoints, APointIsTheCaseWithItsValuesAndNothingElse) {
  const auto points = points_of({{{"pointer", "/cells/0/stretch_modulus"}, {"values", {2e-5}}},
                                 {{"pointer", "/numerics/preset"}, {"values", {"draft"}}},
                                 {{"pointer", "/plasma/density"}, {"values", {1050}}}});
  json expected = scene;
  expected["cells"][0]["stretch_modulus"] = 2e-5;
  expected["numerics"]["preset"] = "draft";
  expected["plasma"]["density"] = 1050;
  EXPECT_EQ(json::parse(points[0].given), expected);
  EXPECT_EQ(to_json(points[0].resolved), to_json(read_case(expected)));
}

TEST(SweepPoints, ACaseNeedNotBeSoundWithoutItsValues) {
  json unsound = scene;
  unsound["duration"] = 0;
  EXPECT_EQ(points_of({{{"pointer", "/duration"}, {"values", {1e-3}}},
                       {{"pointer", "/inflow/velocity"}, {"values", {1e-3}}}},
                      {{"case", unsound}})
                .size(),
            1u);
}

TEST(SweepPoints, EveryPointerThatNamesNothingIsReported) {
  for (const char* pointer :
       {"/nothing", "/cells/1/x", "/cells/-", "/cells/x", "/plasma/density/0", "/vessel~2"}) {
    const Problem problem = problem_of([&] {
      points_of({{{"pointer", "/duration"}, {"values", {1e-3}}},
                 {{"pointer", pointer}, {"values", {1}}},
                 {{"pointer", "/neither"}, {"values", {1}}}});
    });
    EXPECT_EQ(problem.kind().name, "invalid-case") << pointer;
    EXPECT_THAT(pointers_of(problem), ElementsAre("/axes/1/pointer", "/axes/2/pointer")) << pointer;
  }
}

TEST(SweepPoints, EveryBadPointIsReportedWithItsIndexAndValues) {
  const Problem problem = problem_of([] {
    points_of({{{"pointer", "/thrombi/0/radius"}, {"values", {1e-6, -1, 2e-6, "wide"}}}});
  });
  EXPECT_EQ(problem.kind().name, "invalid-case");
  EXPECT_THAT(problem.detail(), HasSubstr("2 of 4 points"));
  ASSERT_THAT(pointers_of(problem), ElementsAre("/case/thrombi/0/radius", "/case/thrombi/0/radius"));
  EXPECT_THAT(problem.faults()[0].message, HasSubstr("point 1 (/thrombi/0/radius = -1): "));
  EXPECT_THAT(problem.faults()[1].message, HasSubstr("point 3 (/thrombi/0/radius = \"wide\"): "));
}

TEST(SweepBody, FaultsAreReportedTogether) {
  const Problem problem = problem_of([] {
    read_sweep({{"case", scene},
                {"mode", "all"},
                {"surprise", 1},
                {"axes",
                 {{{"pointer", "duration"}, {"values", json::array()}},
                  {{"pointer", "/duration"}, {"from", 0}, {"count", 0}, {"step", 1}},
                  7}}},
               default_most_points, {}, {{"/priority", "is wrong"}});
  });
  EXPECT_EQ(problem.kind().name, "invalid-request");
  EXPECT_THAT(
      pointers_of(problem),
      ::testing::UnorderedElementsAre("/priority", "/mode", "/surprise", "/axes/0/pointer", "/axes/0/values",
                                      "/axes/1/step", "/axes/1/to", "/axes/1/count", "/axes/2"));
}

TEST(SweepBody, AxesThatVaryTheSameAndZipsOfUnequalLengthAreRefused) {
  const Problem problem = problem_of([] {
    sweep_of({{{"pointer", "/vessel"}, {"values", {1, 2}}},
              {{"pointer", "/vessel/length"}, {"values", {1, 2}}},
              {{"pointer", "/vessel_"}, {"values", {1, 2, 3}}}},
             {{"mode", "zip"}});
  });
  EXPECT_THAT(pointers_of(problem), ElementsAre("/axes/1/pointer", "/axes/2"));
}

TEST(SweepBody, MoreThanTheMostPointsIsTooLarge) {
  const json axis{{"pointer", "/duration"}, {"from", 1e-3}, {"to", 2e-3}, {"count", 101}};
  const json other{{"pointer", "/inflow/velocity"}, {"from", 1e-3}, {"to", 2e-3}, {"count", 100}};
  EXPECT_EQ(sweep_of(json::array({other})).points, 100u);
  EXPECT_EQ(problem_of([&] { sweep_of({axis, other}); }).kind().name, "sweep-too-large");
  json endless = axis;
  endless["count"] = 18446744073709551615u;
  EXPECT_EQ(problem_of([&] { sweep_of(json::array({endless})); }).kind().name, "sweep-too-large");
  json hundred = axis;
  hundred["count"] = 100;
  const json long_case{{"note", std::string(10'000, 'x')}};
  EXPECT_EQ(problem_of([&] {
              sweep_of({hundred, other}, {{"case", long_case}});
            })
                .kind()
                .name,
            "sweep-too-large");
  json long_values = hundred;
  long_values.erase("from"), long_values.erase("to"), long_values.erase("count");
  long_values["values"] = std::vector<json>(100, std::string(10'000, 'x'));
  EXPECT_EQ(problem_of([&] { sweep_of({long_values, other}); }).kind().name, "sweep-too-large");
}

}  // namespace
}  // namespace rouleau::service
