#include <gmock/gmock.h>

#include <gtest/gtest.h>

#include "tests/unit/engine/case/case_samples.h"

namespace rouleau::testing {
namespace {

using nlohmann::json;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<Fault> with_thrombi(const std::vector<json>& thrombi) {
  return faults_of(with(minimal_case(), "/thrombi", thrombi));
}

std::vector<Fault> with_cells(const std::vector<json>& cells) {
  return faults_of(with(minimal_case(), "/cells", cells));
}

TEST(SceneChecks, TheStudysScenesPass) {
  EXPECT_THAT(faults_of(published_case()), ElementsAre());
  json pair = with(minimal_case(), "/vessel/diameter", 20e-6);
  pair["thrombi"] = {thrombus("lower", 40e-6, 7.2e-6), thrombus("upper", 40e-6, 7.2e-6)};
  pair["cells"] = {cell(16e-6, 5e-6), cell(16.4e-6, 15e-6)};
  EXPECT_THAT(faults_of(pair), ElementsAre());
}

TEST(SceneChecks, AThrombusLiesWithinTheEnds) {
  // One kernel radius of straight wall, 3.1 * 0.4 um, must be left at either end.
  EXPECT_THAT(with_thrombi({thrombus("lower", 4.24e-6, 3e-6)}), ElementsAre());
  EXPECT_THAT(with_thrombi({thrombus("lower", 75.76e-6, 3e-6)}), ElementsAre());
  EXPECT_THAT(pointers(with_thrombi({thrombus("lower", 4.2e-6, 3e-6)})), ElementsAre("/thrombi/0"));
  EXPECT_THAT(with_thrombi({thrombus("upper", 75.8e-6, 3e-6)}).at(0).message,
              HasSubstr("between 1.24e-06 m and 7.88e-05 m"));
  EXPECT_THAT(pointers(with_thrombi({thrombus("lower", 200e-6, 3e-6)})), ElementsAre("/thrombi/0"));
}

TEST(SceneChecks, AThrombusIsAtLeastASpacingHigh) {
  EXPECT_THAT(with_thrombi({thrombus("lower", 40e-6, 4e-7)}), ElementsAre());
  EXPECT_THAT(pointers(with_thrombi({thrombus("lower", 40e-6, 3e-7)})), ElementsAre("/thrombi/0/radius"));
}

TEST(SceneChecks, ThrombiDoNotOverlapOnAWall) {
  EXPECT_THAT(with_thrombi({thrombus("lower", 30e-6, 3e-6), thrombus("lower", 36e-6, 3e-6)}), ElementsAre());
  EXPECT_THAT(pointers(with_thrombi({thrombus("lower", 30e-6, 3e-6), thrombus("lower", 35.9e-6, 3e-6)})),
              ElementsAre("/thrombi/1"));
  const auto twice = with_thrombi({thrombus("upper", 30e-6, 3e-6), thrombus("upper", 30e-6, 3e-6)});
  ASSERT_THAT(pointers(twice), ElementsAre("/thrombi/1"));
  EXPECT_THAT(twice[0].message, HasSubstr("overlaps thrombus 0"));
  EXPECT_THAT(with_thrombi({thrombus("lower", 30e-6, 3e-6), thrombus("upper", 30e-6, 3e-6)}), ElementsAre());
}

TEST(SceneChecks, ThrombiLeaveTheVesselOpen) {
  EXPECT_THAT(with_thrombi({thrombus("lower", 40e-6, 9.1e-6)}), ElementsAre());
  EXPECT_THAT(with_thrombi({thrombus("lower", 40e-6, 9.2e-6)}).at(0).message, HasSubstr("closes the vessel"));
  EXPECT_THAT(pointers(with_thrombi({thrombus("lower", 40e-6, 12e-6)})), ElementsAre("/thrombi/0"));

  EXPECT_THAT(with_thrombi({thrombus("lower", 40e-6, 4.5e-6), thrombus("upper", 40e-6, 4.5e-6)}),
              ElementsAre());
  EXPECT_THAT(pointers(with_thrombi({thrombus("lower", 40e-6, 4.7e-6), thrombus("upper", 40e-6, 4.7e-6)})),
              ElementsAre("/thrombi/1"));
  // Apart along the vessel the same pair leaves its gap on the slant: hypot(5, 10) - 9.4 = 1.78 um.
  EXPECT_THAT(with_thrombi({thrombus("lower", 40e-6, 4.7e-6), thrombus("upper", 45e-6, 4.7e-6)}),
              ElementsAre());
}

TEST(SceneChecks, ACellLiesInsideTheVessel) {
  EXPECT_THAT(with_cells({cell(16e-6, 5e-6)}), ElementsAre());
  EXPECT_THAT(with_cells({cell(16e-6, 2e-6, 0)}), ElementsAre());
  EXPECT_THAT(with_cells({cell(16e-6, 4e-6)}).at(0).message, HasSubstr("beyond the lower wall"));
  EXPECT_THAT(with_cells({cell(16e-6, 6e-6)}).at(0).message, HasSubstr("beyond the upper wall"));
  EXPECT_THAT(with_cells({cell(1e-6, 5e-6)}).at(0).message, HasSubstr("beyond the inlet"));
  EXPECT_THAT(with_cells({cell(79e-6, 5e-6)}).at(0).message, HasSubstr("beyond the outlet"));
  EXPECT_THAT(with_cells({cell(4e-6, 5e-6, 0)}).at(0).message, HasSubstr("beyond the inlet"));
  EXPECT_THAT(with_cells({cell(4e-6, 5e-6, 90)}), ElementsAre());
  EXPECT_THAT(with_cells({cell(16e-6, 2e-6, 30)}).at(0).pointer, "/cells/0");
  EXPECT_THAT(with_cells({cell(0.5, 0.5)}).at(0).message, HasSubstr("lies outside the vessel"));
  EXPECT_THAT(with_cells({cell(16e-6, 9e-6)}).at(0).message, HasSubstr("reaches 3.34e-06 m beyond"));
}

TEST(SceneChecks, ACellLiesOutsideThrombi) {
  json document = published_case();
  document["cells"][0]["x"] = 28.5e-6;
  EXPECT_THAT(faults_of(document).at(0).message, HasSubstr("into thrombus 0"));
  document["cells"][0]["x"] = 26e-6;
  EXPECT_THAT(faults_of(document), ElementsAre());
  document["cells"][0] = cell(32e-6, 8e-6, 0);
  EXPECT_THAT(faults_of(document), ElementsAre());
  document["thrombi"][0]["wall"] = "upper";
  EXPECT_THAT(pointers(faults_of(document)), ElementsAre("/cells/0"));
}

TEST(SceneChecks, CellsDoNotOverlap) {
  EXPECT_THAT(with_cells({cell(16e-6, 5e-6), cell(18.5e-6, 5e-6)}), ElementsAre());
  EXPECT_THAT(pointers(with_cells({cell(16e-6, 5e-6), cell(18e-6, 5e-6)})), ElementsAre("/cells/1"));
  const auto crossed = with_cells({cell(16e-6, 5e-6), cell(16e-6, 5e-6, 0)});
  ASSERT_THAT(pointers(crossed), ElementsAre("/cells/1"));
  EXPECT_THAT(crossed[0].message, HasSubstr("overlaps cell 0"));
  EXPECT_THAT(pointers(with_cells({cell(16e-6, 5e-6), cell(30e-6, 5e-6), cell(16e-6, 5e-6)})),
              ElementsAre("/cells/2"));
}

std::vector<Fault> in_periodic_vessel(const std::vector<json>& cells) {
  return faults_of(with(periodic_case(), "/cells", cells));
}

TEST(SceneChecks, ACellMayLieAcrossTheSeamOfAPeriodicVessel) {
  EXPECT_THAT(in_periodic_vessel({cell(0, 5e-6, 0)}), ElementsAre());
  EXPECT_THAT(in_periodic_vessel({cell(19e-6, 5e-6)}), ElementsAre());
  EXPECT_THAT(in_periodic_vessel({cell(21e-6, 5e-6)}).at(0).message, HasSubstr("lies outside the vessel"));
  EXPECT_THAT(in_periodic_vessel({cell(0, 4e-6)}).at(0).message, HasSubstr("beyond the lower wall"));
}

TEST(SceneChecks, CellsDoNotOverlapAcrossASeam) {
  EXPECT_THAT(in_periodic_vessel({cell(1e-6, 5e-6), cell(18e-6, 5e-6)}), ElementsAre());
  const auto pair = in_periodic_vessel({cell(1e-6, 5e-6), cell(19e-6, 5e-6)});
  ASSERT_THAT(pointers(pair), ElementsAre("/cells/1"));
  EXPECT_THAT(pair[0].message, HasSubstr("overlaps cell 0"));
  json document = with(periodic_case(), "/cells", json::array({cell(4e-6, 5e-6, 0)}));
  document["vessel"]["length"] = 8.8e-6;
  EXPECT_THAT(faults_of(document), ElementsAre());
  document["vessel"]["length"] = 8.6e-6;
  EXPECT_THAT(faults_of(document).at(0).message, HasSubstr("overlaps its own image"));
}

TEST(SceneChecks, ACellLiesOutsideThrombiAcrossASeam) {
  json document = with(periodic_case(), "/cells", json::array({cell(19.9e-6, 8e-6, 0)}));
  document["thrombi"] = {thrombus("lower", 4.5e-6, 3.2e-6)};
  EXPECT_THAT(faults_of(document), ElementsAre());
  document["cells"][0]["y"] = 2e-6;
  EXPECT_THAT(faults_of(document).at(0).message, HasSubstr("into thrombus 0"));
}

TEST(SceneChecks, ACellIsThickEnoughToBeResolved) {
  json small = cell(16e-6, 5e-6);
  small["diameter"] = 3.2e-6;
  EXPECT_THAT(with_cells({small}), ElementsAre());
  small["diameter"] = 3.1e-6;
  EXPECT_THAT(with_cells({small}).at(0).message, HasSubstr("thick in the mean"));
}

TEST(SceneChecks, TheSpacingFitsTheVessel) {
  EXPECT_THAT(faults_of(with(minimal_case(), "/vessel/diameter", 3.2e-6)), ElementsAre());
  EXPECT_THAT(pointers(faults_of(with(minimal_case(), "/vessel/diameter", 3.1e-6))),
              ElementsAre("/numerics/spacing"));
  EXPECT_THAT(pointers(faults_of(with(minimal_case(), "/vessel/length", 3.1e-6))),
              ElementsAre("/numerics/spacing"));
  EXPECT_THAT(faults_of(with(minimal_case(), "/numerics/spacing", 1.25e-6)), ElementsAre());
  EXPECT_THAT(faults_of(with(minimal_case(), "/numerics/spacing", 1e-8)).at(0).message,
              HasSubstr("8e+06 particles"));
}

TEST(SceneChecks, TheArchiveStaysFinite) {
  json document = with(minimal_case(), "/output/series_interval", 1e-12);
  document["output"]["frame_interval"] = 1e-9;
  EXPECT_THAT(pointers(faults_of(document)),
              ElementsAre("/output/series_interval", "/output/frame_interval"));
}

TEST(SceneChecks, PartsThatAreFaultyThemselvesAreLeftOut) {
  json document = published_case();
  document["thrombi"][0]["radius"] = "large";
  document["cells"].push_back({{"x", 16e-6}, {"y", 5e-6}, {"diamter", 1e-6}});
  document["cells"].push_back(cell(16e-6, 5e-6));
  EXPECT_THAT(pointers(faults_of(document)),
              ElementsAre("/thrombi/0/radius", "/cells/1/diamter", "/cells/2"));
  document["vessel"]["diameter"] = -1;
  EXPECT_THAT(pointers(faults_of(document)), Contains("/vessel/diameter"));
  EXPECT_EQ(faults_of(document).size(), 3U);
}

}  // namespace
}  // namespace rouleau::testing
