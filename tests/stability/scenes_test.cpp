#include "tests/stability/scenes.h"

#include <gmock/gmock.h>

#include <gtest/gtest.h>

#include "tests/stability/known_misses.h"

namespace rouleau::stability {
namespace {

class HardCase : public testing::TestWithParam<Scene> {};

std::string described(const Report& report) {
  std::string text = report.outcome + " " + report.message;
  for (const auto& [name, worst] : report.worst) {
    text += "\n  " + name + " " + std::to_string(worst.value) + ", bound " + std::to_string(worst.bound) +
            ", at t = " + std::to_string(worst.time * 1e3) + " ms, x = " + std::to_string(worst.x * 1e6) +
            ", y = " + std::to_string(worst.y * 1e6) + " um";
  }
  return text;
}

TEST_P(HardCase, KeepsItsBoundsOrIsKnownNotTo) {
  const Report report = GetParam().run(Form::brief);
  const std::vector<std::string> misses = report.misses();
  const auto known = known_misses.find(GetParam().name);
  if (known == known_misses.end()) {
    EXPECT_THAT(misses, testing::IsEmpty()) << described(report);
    return;
  }
  EXPECT_THAT(misses, testing::Not(testing::IsEmpty())) << "mended: take it off known_misses.h";
  for (const std::string& miss : misses)
    EXPECT_THAT(known->second, testing::Contains(miss)) << described(report);
}

INSTANTIATE_TEST_SUITE_P(Scenes, HardCase, testing::ValuesIn(scenes()),
                         [](const auto& scene) { return scene.param.name; });

TEST(KnownMisses, AreOfScenesThatThereAre) {
  for (const auto& [name, misses] : known_misses) {
    EXPECT_NO_THROW(scene_named(name));
    EXPECT_FALSE(misses.empty()) << name;
  }
}

}  // namespace
}  // namespace rouleau::stability
