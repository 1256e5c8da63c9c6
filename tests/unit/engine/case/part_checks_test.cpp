#include <gmock/gmock.h>

#include <gtest/gtest.h>

#include "tests/unit/engine/case/case_samples.h"

namespace rouleau::testing {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

void expect_only_fault(const json& document, const std::string& pointer, const std::string& message) {
  const std::vector<Fault> faults = faults_of(document);
  ASSERT_THAT(pointers(faults), ElementsAre(pointer)) << document;
  EXPECT_THAT(faults[0].message, HasSubstr(message)) << document;
}

void expect_sound(const json& document) {
  EXPECT_THAT(faults_of(document), ElementsAre()) << document;
}

json periodic_box() {
  return with(box_case(), "/vessel/ends", "periodic");
}

TEST(PartChecks, EveryKindOfCaseReads) {
  for (const json& document : cases_of_every_kind()) expect_sound(document);
}

TEST(PartChecks, AVesselTakesTheKeysOfItsShapeAlone) {
  expect_only_fault(with(minimal_case(), "/vessel/half_angle", 30), "/vessel/half_angle",
                    "it belongs to the shape \"bifurcation\"; allowed here: shape, length, diameter, ends");
  expect_only_fault(with(bifurcation_case(), "/vessel/length", 1e-5), "/vessel/length",
                    "belongs to the shape \"straight\"");
  expect_only_fault(with(bifurcation_case(), "/vessel/ends", "open"), "/vessel/ends",
                    "belongs to the shape \"straight\" or \"box\"");
  expect_only_fault(with(box_case(), "/vessel/diameter", 1e-5), "/vessel/diameter",
                    "belongs to the shape \"straight\"");
  EXPECT_THAT(pointers(faults_of(case_in({{"shape", "bifurcation"}}))),
              ElementsAre("/vessel/trunk", "/vessel/branches"));
  EXPECT_THAT(pointers(faults_of(case_in({{"shape", "box"}}))),
              ElementsAre("/vessel/width", "/vessel/height"));
}

TEST(PartChecks, OnlyAnOpenVesselIsFed) {
  for (const json& closed : {periodic_case(), box_case(), periodic_box()}) {
    expect_only_fault(with(closed, "/inflow", json::object()), "/inflow", "has no inlet");
    expect_only_fault(with(closed, "/outflow", json::object()), "/outflow", "has no outlet");
    expect_sound(with(closed, "/body_acceleration", {600, 0}));
  }
  for (const json& open : {minimal_case(), bifurcation_case()}) {
    expect_only_fault(with(open, "/body_acceleration", {600, 0}), "/body_acceleration",
                      "driven by its inflow");
  }
}

TEST(PartChecks, WallsMoveWhereNothingIsFed) {
  expect_sound(with(periodic_case(), "/vessel/wall_velocity/upper", 0.01));
  expect_sound(with(box_case(), "/vessel/wall_velocity/left", 0.01));
  expect_only_fault(with(minimal_case(), "/vessel/wall_velocity/upper", 0.01), "/vessel/wall_velocity",
                    "take periodic ends");
  expect_only_fault(with(periodic_box(), "/vessel/wall_velocity/upper", 0.01), "/vessel/wall_velocity",
                    "has no walls");
  expect_only_fault(with(periodic_case(), "/vessel/wall_velocity/left", 0.01), "/vessel/wall_velocity/left",
                    "unknown key");
}

TEST(PartChecks, TwoPressuresNeedTwoOutlets) {
  expect_only_fault(with(minimal_case(), "/outflow/pressure", {1, 2}), "/outflow/pressure", "one outlet");
  EXPECT_THAT(read_case(with(bifurcation_case(), "/outflow/pressure", {1, 2})).outflow.pressure,
              ElementsAre(1, 2));
  EXPECT_THAT(read_case(with(bifurcation_case(), "/outflow/pressure", 3)).outflow.pressure,
              ElementsAre(3, 3));
}

TEST(PartChecks, EveryVesselTakesCells) {
  const json cells = {{{"x", 10e-6}, {"y", 5e-6}}};
  expect_sound(with(periodic_case(), "/cells", cells));
  expect_sound(with(periodic_box(), "/cells", cells));
  expect_sound(with(box_case(), "/cells", cells));
}

TEST(PartChecks, ACellDeflatesWhereItsFluidCanLeave) {
  const json circle = {{{"x", 10e-6}, {"y", 5e-6}, {"shape", "circle"}}};
  EXPECT_EQ(read_case(with(minimal_case(), "/cells", circle)).cells.at(0).shape, CellShape::circle);
  for (const json& tight : {box_case(), periodic_case()}) {
    expect_only_fault(with(tight, "/cells", circle), "/cells/0/shape", "cannot leave");
    expect_sound(with(with(tight, "/cells", circle), "/cells/0/fill", 1));
  }
}

TEST(PartChecks, ThePaperPresetKnowsNeitherCirclesNorViscousCells) {
  json document = with(paper_case(), "/cells", {{{"x", 10e-6}, {"y", 5e-6}}});
  expect_sound(document);
  expect_only_fault(with(document, "/cells/0/shape", "circle"), "/cells/0/shape", "start relaxed");
  expect_only_fault(with(document, "/cells/0/viscosity_ratio", 5), "/cells/0/viscosity_ratio",
                    "as viscous as plasma");
}

TEST(PartChecks, ThrombiSitOnWalls) {
  const json thrombi = {{{"wall", "upper"}, {"x", 10e-6}, {"radius", 3e-6}}};
  expect_sound(with(periodic_case(), "/thrombi", thrombi));
  expect_sound(with(box_case(), "/thrombi", thrombi));
  expect_only_fault(with(periodic_box(), "/thrombi", thrombi), "/thrombi", "no walls");
  const json sliding = with(periodic_case(), "/thrombi", thrombi);
  expect_sound(with(sliding, "/vessel/wall_velocity/lower", 0.01));
  expect_only_fault(with(sliding, "/vessel/wall_velocity/upper", 0.01), "/thrombi/0",
                    "sits on the upper wall, which moves at 0.01 m/s");
}

TEST(PartChecks, TheInitialFlowSuitsTheVessel) {
  const auto starting = [](json document, const char* flow) {
    document.erase("initial");
    return with(document, "/initial/flow", flow);
  };
  for (const json& document : {minimal_case(), periodic_case(), bifurcation_case()}) {
    for (const char* flow : {"auto", "rest", "developed"}) expect_sound(starting(document, flow));
    EXPECT_THAT(pointers(faults_of(starting(document, "taylor_green"))),
                ElementsAre("/initial/flow", "/initial/velocity"));
  }
  for (const json& document : {box_case(), periodic_box()}) {
    for (const char* flow : {"auto", "rest"}) expect_sound(starting(document, flow));
    expect_only_fault(starting(document, "developed"), "/initial/flow", "has no developed flow");
  }
  expect_only_fault(starting(periodic_box(), "taylor_green"), "/initial/velocity", "missing");
  expect_only_fault(with(box_case(), "/initial", {{"flow", "taylor_green"}, {"velocity", 1}}),
                    "/initial/flow", "this is a closed box");
  expect_only_fault(with(minimal_case(), "/initial/velocity", 1), "/initial/velocity",
                    "only taylor_green takes a velocity");
  EXPECT_EQ(read_case(vortex_case()).initial.velocity, 0.01);
}

TEST(PartChecks, TheSceneDecidesTheInitialFlow) {
  EXPECT_EQ(initial_flow(read_case(minimal_case())), InitialFlow::developed);
  EXPECT_EQ(initial_flow(read_case(bifurcation_case())), InitialFlow::developed);
  EXPECT_EQ(initial_flow(read_case(periodic_case())), InitialFlow::rest);
  EXPECT_EQ(initial_flow(read_case(box_case())), InitialFlow::rest);
  EXPECT_EQ(initial_flow(read_case(vortex_case())), InitialFlow::taylor_green);
  EXPECT_EQ(initial_flow(read_case(with(minimal_case(), "/initial/flow", "rest"))), InitialFlow::rest);
}

TEST(PartChecks, TheWaveformRunsForward) {
  expect_sound(with(minimal_case(), "/inflow/waveform", {{0, 1}, {1e-9, -1}, {1, 0}}));
  expect_only_fault(with(minimal_case(), "/inflow/waveform", {{0, 1}, {0.2, -1}, {0.2, 0}}),
                    "/inflow/waveform/2", "found the time 0.2 s after 0.2 s; times must increase");
  EXPECT_THAT(pointers(faults_of(with(minimal_case(), "/inflow/waveform", {{3, 1}, {2, 1}, {1, 1}}))),
              ElementsAre("/inflow/waveform/1", "/inflow/waveform/2"));
}

TEST(PartChecks, TheNumericsBelongTogether) {
  expect_only_fault(with(minimal_case(), "/numerics/viscosity", "substeps"), "/numerics/viscosity",
                    "choose the preset paper");
  expect_only_fault(with(paper_case(), "/numerics/viscosity", "implicit"), "/numerics/viscosity",
                    "choose another preset");
  expect_only_fault(with(minimal_case(), "/numerics/kernel_radius", 2.5), "/numerics/kernel_radius",
                    "need at least 2.6");
  expect_sound(with(minimal_case(), "/numerics/kernel_radius", 2.6));
  expect_only_fault(with(minimal_case(), "/numerics/substeps", 12), "/numerics/substeps",
                    "implicit viscosity takes no substeps");
  expect_sound(with(paper_case(), "/numerics/substeps", 12));
}

}  // namespace
}  // namespace rouleau::testing
