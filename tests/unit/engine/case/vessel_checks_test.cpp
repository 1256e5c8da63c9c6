#include <cmath>
#include <gmock/gmock.h>

#include <gtest/gtest.h>

#include "tests/unit/engine/case/case_samples.h"

namespace rouleau::testing {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

json branch(double length, double diameter) {
  return {{"length", length}, {"diameter", diameter}};
}

std::vector<Fault> with_thrombi(const std::vector<json>& thrombi) {
  return faults_of(with(bifurcation_case(), "/thrombi", thrombi));
}

std::vector<Fault> with_cell(const json& document, const json& placed) {
  return faults_of(with(document, "/cells", json::array({placed})));
}

std::vector<Fault> with_branches(const json& branches) {
  return faults_of(with(bifurcation_case(), "/vessel/branches", branches));
}

TEST(VesselChecks, EveryPartOfABifurcationIsResolved) {
  EXPECT_THAT(with_branches(branch(40e-6, 3.2e-6)), ElementsAre());
  const auto narrow = with_branches({branch(40e-6, 10e-6), branch(40e-6, 3.1e-6)});
  ASSERT_THAT(pointers(narrow), ElementsAre("/numerics/spacing"));
  EXPECT_THAT(narrow[0].message, HasSubstr("across the upper branch (4e-05 m by 3.1e-06 m)"));
  EXPECT_THAT(faults_of(with(bifurcation_case(), "/numerics/spacing", 1e-8)).at(0).message,
              HasSubstr("fills the vessel"));
}

TEST(VesselChecks, TheInnerWallsMeetAheadOfTheOutlets) {
  // At 30 degrees branches of 18 um meet 36 - 17.3 = 18.7 um past the trunk's end, 11.2 um along either.
  EXPECT_THAT(with_branches(branch(29.3e-6, 18e-6)), ElementsAre());
  const auto both = with_branches(branch(29e-6, 18e-6));
  ASSERT_THAT(pointers(both), ElementsAre("/vessel/branches", "/vessel/branches"));
  EXPECT_THAT(both[0].message, AllOf(HasSubstr("the inner wall of the lower branch is 1.78e-05 m long"),
                                     HasSubstr("a branch longer than 2.92e-05 m would do")));
  const auto one = with_branches({branch(60e-6, 18e-6), branch(20e-6, 18e-6)});
  ASSERT_THAT(pointers(one), ElementsAre("/vessel/branches"));
  EXPECT_THAT(one[0].message, HasSubstr("upper branch"));
}

TEST(VesselChecks, TheTrunkIsLongerThanWideAheadOfTheApex) {
  json document = bifurcation_case();
  // The apex lies 2.68 um past the trunk's end.
  document["vessel"]["trunk"]["length"] = 17.4e-6;
  EXPECT_THAT(faults_of(document), ElementsAre());
  document["vessel"]["trunk"]["length"] = 17.2e-6;
  ASSERT_THAT(pointers(faults_of(document)), ElementsAre("/vessel/trunk"));
  EXPECT_THAT(faults_of(document)[0].message, HasSubstr("a trunk longer than 1.73e-05 m would do"));
}

TEST(VesselChecks, AThrombusSitsOnOneOuterWallOfABifurcation) {
  // 1.24 um of straight wall on either side of the corner: 3 + 1.24 = 4.24 um along the wall.
  const double along = std::sqrt(0.75);
  EXPECT_THAT(with_thrombi({thrombus("lower", 75.7e-6, 3e-6)}), ElementsAre());
  EXPECT_THAT(with_thrombi({thrombus("upper", 80e-6 + along * 4.3e-6, 3e-6)}), ElementsAre());
  EXPECT_THAT(with_thrombi({thrombus("lower", 80e-6 + along * 35.7e-6, 3e-6)}), ElementsAre());
  EXPECT_THAT(with_thrombi({thrombus("upper", 75.8e-6, 3e-6)}).at(0).message,
              HasSubstr("along the trunk's upper wall; it must lie between 1.24e-06 m and 7.88e-05 m"));
  EXPECT_THAT(
      with_thrombi({thrombus("lower", 80e-6 + along * 4.2e-6, 3e-6)}).at(0).message,
      HasSubstr("along the lower branch's outer wall; it must lie between 1.24e-06 m and 3.88e-05 m"));
  EXPECT_THAT(pointers(with_thrombi({thrombus("lower", 80e-6 + along * 35.8e-6, 3e-6)})),
              ElementsAre("/thrombi/0"));
}

TEST(VesselChecks, AThrombusLeavesTheBranchOpen) {
  const double middle = 80e-6 + std::sqrt(0.75) * 20e-6;
  EXPECT_THAT(with_thrombi({thrombus("upper", middle, 9.1e-6)}), ElementsAre());
  EXPECT_THAT(with_thrombi({thrombus("upper", middle, 9.3e-6)}).at(0).message,
              HasSubstr("closes the vessel: it leaves 7e-07 m open"));
  // In the trunk the apex is as near as the wall opposite once the thrombus is near the branches.
  EXPECT_THAT(with_thrombi({thrombus("lower", 66.5e-6, 12e-6)}), ElementsAre());
  json pointed = with(bifurcation_case(), "/vessel/branches", branch(40e-6, 4e-6));
  EXPECT_THAT(
      pointers(faults_of(with(pointed, "/thrombi", json::array({thrombus("lower", 66.5e-6, 12e-6)})))),
      ElementsAre("/thrombi/0"));
}

TEST(VesselChecks, ThrombiInDifferentBranchesDoNotMeet) {
  const double middle = 80e-6 + std::sqrt(0.75) * 20e-6;
  EXPECT_THAT(with_thrombi({thrombus("lower", middle, 9e-6), thrombus("upper", middle, 9e-6)}),
              ElementsAre());
  EXPECT_THAT(pointers(with_thrombi({thrombus("lower", 60e-6, 9.7e-6), thrombus("upper", 60e-6, 9.7e-6)})),
              ElementsAre("/thrombi/1"));
  EXPECT_THAT(
      pointers(with_thrombi({thrombus("lower", middle, 4e-6), thrombus("lower", middle + 6e-6, 4e-6)})),
      ElementsAre("/thrombi/1"));
}

TEST(VesselChecks, ACellFitsTheTrunkOrABranch) {
  const auto placed = [](const json& one) { return with_cell(bifurcation_case(), one); };
  EXPECT_THAT(placed(cell(40e-6, 10e-6)), ElementsAre());
  // The middle of the lower branch, half way along: 20 um along its wall, 5 um off it.
  const double x = 80e-6 + std::sqrt(0.75) * 20e-6 + 0.5 * 5e-6, y = -0.5 * 20e-6 + std::sqrt(0.75) * 5e-6;
  EXPECT_THAT(placed(cell(x, y, -30)), ElementsAre());
  EXPECT_THAT(placed(cell(x, 20e-6 - y, 30)), ElementsAre());
  EXPECT_THAT(placed(cell(x, y, 60)), ElementsAre());
  const auto across = placed(cell(x, y + 2e-6, 60));
  ASSERT_THAT(pointers(across), ElementsAre("/cells/0"));
  EXPECT_THAT(across[0].message, HasSubstr("beyond the lower branch's inner wall"));
  EXPECT_THAT(placed(cell(80e-6, 10e-6)).size(), 0U);
  EXPECT_THAT(placed(cell(82e-6, 10e-6)).at(0).message, HasSubstr("branch's inner wall"));
  EXPECT_THAT(placed(cell(110e-6, 10e-6)).at(0).message, HasSubstr("lies outside the vessel"));
  EXPECT_THAT(placed(cell(118e-6, -14e-6, -30)).at(0).message, HasSubstr("beyond the lower outlet"));
}

TEST(VesselChecks, ACellFitsTheBox) {
  EXPECT_THAT(with_cell(box_case(), cell(15e-6, 10e-6)), ElementsAre());
  EXPECT_THAT(with_cell(box_case(), cell(29e-6, 10e-6)).at(0).message, HasSubstr("beyond the right wall"));
  EXPECT_THAT(with_cell(box_case(), cell(1e-6, 10e-6)).at(0).message, HasSubstr("beyond the left wall"));
}

TEST(VesselChecks, AThrombusKeepsOffTheCornersOfABox) {
  const auto placed = [](double x, double radius) {
    return faults_of(with(box_case(), "/thrombi", json::array({thrombus("upper", x, radius)})));
  };
  EXPECT_THAT(placed(15e-6, 5e-6), ElementsAre());
  EXPECT_THAT(placed(6e-6, 5e-6).at(0).message, HasSubstr("along the upper wall"));
  EXPECT_THAT(pointers(placed(15e-6, 19.5e-6)), ElementsAre("/thrombi/0", "/thrombi/0"));
}

std::vector<Fault> with_probes(const json& document, const std::vector<json>& probes) {
  return faults_of(with(document, "/probes", probes));
}

TEST(VesselChecks, ProbesLieInTheBoundsOfTheVessel) {
  const auto line = [](double x, double y) -> std::vector<json> {
    return {{{"name", "line"}, {"from", {10e-6, 5e-6}}, {"to", {x, y}}, {"points", 2}}};
  };
  EXPECT_THAT(with_probes(minimal_case(), line(80e-6, 10e-6)), ElementsAre());
  const auto beyond = with_probes(minimal_case(), line(81e-6, -1e-6));
  ASSERT_THAT(pointers(beyond), ElementsAre("/probes/0/to/0", "/probes/0/to/1"));
  EXPECT_THAT(beyond[0].message, HasSubstr("found 8.1e-05 m; the vessel reaches from 0 m to 8e-05 m"));
  // The lower branch of a bifurcation reaches down to y = -40 um sin 30.
  EXPECT_THAT(with_probes(bifurcation_case(), line(110e-6, -19.9e-6)), ElementsAre());
  EXPECT_THAT(pointers(with_probes(bifurcation_case(), line(110e-6, -20.1e-6))),
              ElementsAre("/probes/0/to/1"));
  EXPECT_THAT(pointers(with_probes(minimal_case(), {{{"name", "point"}, {"from", {-1e-6, 0}}}})),
              ElementsAre("/probes/0/from/0"));
}

TEST(VesselChecks, ProbesHaveTheirPointsAndNames) {
  const json line = {{"name", "a"}, {"from", {10e-6, 5e-6}}, {"to", {10e-6, 6e-6}}, {"points", 2}};
  EXPECT_THAT(with_probes(minimal_case(), {line}), ElementsAre());
  EXPECT_THAT(with_probes(minimal_case(), {with(line, "/points", 1)}).at(0).message,
              HasSubstr("found 1 on a line; at least 2 are needed"));
  json single = line;
  single.erase("to");
  EXPECT_THAT(pointers(with_probes(minimal_case(), {single})), ElementsAre("/probes/0/points"));
  single.erase("points");
  EXPECT_THAT(with_probes(minimal_case(), {single}), ElementsAre());
  const auto twice = with_probes(minimal_case(), {line, with(line, "/name", "A"), line});
  ASSERT_THAT(pointers(twice), ElementsAre("/probes/2/name"));
  EXPECT_THAT(twice[0].message, HasSubstr("the name of probe 0"));
}

}  // namespace
}  // namespace rouleau::testing
