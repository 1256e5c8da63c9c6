#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "engine/case/presets.h"
#include "engine/plan/plan.h"
#include "engine/simulation/calibration.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau {
namespace {

double sum_of_shares(const Plan& plan) {
  double sum = 0;
  for (const PlannedEffect& effect : plan.effects) sum += effect.share;
  return sum;
}

double share(const Plan& plan, const std::string& name) {
  return std::find_if(plan.effects.begin(), plan.effects.end(),
                      [&](const PlannedEffect& effect) { return effect.name == name; })
      ->share;
}

TEST(ExpectedCost, OfEveryExampleIsFiniteAndMadeUpOfItsEffects) {
  int examples = 0;
  for (const auto& entry : std::filesystem::directory_iterator(ROULEAU_EXAMPLES)) {
    const bool is_case = entry.path().extension() == ".json" && entry.path().stem() != "sweep";
    if (!is_case) continue;
    std::ifstream file(entry.path());
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const Case scene = read_case(text, check_effects);
    const Plan plan = make_plan(scene);
    SCOPED_TRACE(entry.path().filename());
    ++examples;
    EXPECT_NEAR(sum_of_shares(plan), 1, 1e-12);
    for (const PlannedEffect& effect : plan.effects) {
      EXPECT_TRUE(effect.on ? effect.share >= 0 : effect.share == 0) << effect.name;
    }
    for (const double number : {plan.wall_time, plan.memory, plan.step_time, plan.expected_steps,
                                plan.expected_error.velocity, plan.expected_error.tau.value_or(1)}) {
      EXPECT_TRUE(std::isfinite(number) && number > 0);
    }
    EXPECT_GE(plan.expected_steps, static_cast<double>(plan.steps) * (1 - 1e-9));
    EXPECT_EQ(plan.expected_error.tau.has_value(), !scene.cells.empty());
    EXPECT_LT(plan.expected_error.velocity, 0.5);
  }
  EXPECT_GT(examples, 10);
}

TEST(ExpectedCost, GrowsWithParticlesStepsCellsAndOutput) {
  Case scene = coarse_vessel();
  const Plan plain = make_plan(scene);
  Case longer = scene;
  longer.vessel.length *= 4;
  EXPECT_GT(make_plan(longer).wall_time, plain.wall_time);
  EXPECT_GT(make_plan(longer).memory, plain.memory);
  Case finer = scene;
  finer.numerics.spacing /= 2;
  EXPECT_GT(make_plan(finer).step_time, 2.5 * plain.step_time);
  EXPECT_GT(make_plan(finer).wall_time, plain.wall_time);
  EXPECT_LT(make_plan(finer).expected_error.velocity, plain.expected_error.velocity);
  const Case cells = coarse_vessel_with_cells();
  EXPECT_GT(make_plan(cells).step_time, plain.step_time);
  scene.output.frame_interval /= 100;
  EXPECT_GT(share(make_plan(scene), "frames"), share(plain, "frames"));
}

TEST(ExpectedCost, OfACaseThatRunsTwiceAsLongIsTwiceThatOfItsSteps) {
  Case scene = coarse_vessel();
  scene.output = {};
  scene.duration = 1;
  const Plan once = make_plan(scene);
  scene.duration = 2;
  EXPECT_NEAR(make_plan(scene).wall_time / once.wall_time, 2, 0.01);
}

TEST(ExpectedCost, IsThatOfTheMachine) {
  const Plan like = make_plan(coarse_vessel()), slow = make_plan(coarse_vessel(), {3, true});
  EXPECT_DOUBLE_EQ(slow.wall_time, 3 * like.wall_time);
  EXPECT_EQ(slow.step_time, like.step_time);
  EXPECT_FALSE(to_json(like)["machine"]["measured"].get<bool>());
  EXPECT_EQ(to_json(slow)["machine"]["slowness"], 3);
}

TEST(ExpectedCost, OfAStepThatTheFlowHoldsBackIsThatOfShorterOnes) {
  Case scene = coarse_vessel();
  const double planned = make_plan(scene).time_step;
  scene.numerics.time_step = 10 * planned;
  const Plan plan = make_plan(scene);
  EXPECT_LT(plan.steps, 6);
  // The flow allows two and a half of the steps that the plan would choose.
  EXPECT_NEAR(plan.expected_steps, scene.duration / (2.5 * planned), 0.05 * plan.expected_steps + 1);
}

TEST(ExpectedCost, ForeseesThatALimpCellWillBeRefined) {
  Case scene = coarse_vessel_with_cells();
  scene.numerics = preset_numerics(Preset::draft);
  scene.duration = 0.01;
  const Plan stiff = [&] {
    Case stiffer = scene;
    stiffer.cells[0].stretch_modulus = 1e-3;
    return make_plan(stiffer);
  }();
  scene.cells[0].stretch_modulus = 2e-6;
  const Plan limp = make_plan(scene);
  EXPECT_NEAR(stiff.expected_steps, static_cast<double>(stiff.steps), 1e-6 * stiff.expected_steps);
  EXPECT_GT(limp.expected_steps, 1.3 * static_cast<double>(limp.steps));
  EXPECT_GT(limp.memory, stiff.memory);
}

TEST(ExpectedError, GrowsWithTheSpacingAndWhatIsInTheWay) {
  Case scene = coarse_vessel();
  scene.inflow.profile = Profile::parabolic;
  const double parabola = make_plan(scene).expected_error.velocity;
  scene.thrombi = {{Wall::lower, 7e-6, 3e-6}};
  const double past_thrombus = make_plan(scene).expected_error.velocity;
  scene.inflow.profile = Profile::plug;
  const double plug = make_plan(scene).expected_error.velocity;
  EXPECT_LT(10 * parabola, past_thrombus);
  EXPECT_LT(past_thrombus, plug);
  scene.numerics = preset_numerics(Preset::paper);
  EXPECT_GT(make_plan(scene).expected_error.velocity, 3 * plug);
}

TEST(Calibration, MeasuresAMachineThatIsLikeItself) {
  const Machine machine = measure_machine();
  EXPECT_TRUE(machine.measured);
  EXPECT_GT(machine.slowness, 0.01);
  EXPECT_LT(machine.slowness, 1000);
}

}  // namespace
}  // namespace rouleau
