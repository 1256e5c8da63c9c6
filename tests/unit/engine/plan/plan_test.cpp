#include "engine/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/case/case_error.h"
#include "engine/case/case_json.h"
#include "engine/case/presets.h"
#include "engine/effects/effect.h"
#include "engine/observe/observer.h"
#include "engine/simulation/simulation.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau {
namespace {

const PlannedEffect& effect(const Plan& plan, const std::string& name) {
  return *std::find_if(plan.effects.begin(), plan.effects.end(),
                       [&](const PlannedEffect& e) { return e.name == name; });
}

std::set<std::string> pointers_of_faults(const Case& scene) {
  std::set<std::string> pointers;
  try {
    make_plan(scene);
  } catch (const CaseError& error) {
    for (const Fault& fault : error.faults()) {
      pointers.insert(fault.pointer);
      EXPECT_FALSE(fault.message.empty());
    }
    EXPECT_EQ(pointers.size(), error.faults().size());
  }
  return pointers;
}

TEST(Plan, ListsEveryEffectOfTheCatalogueInItsOrder) {
  const Plan plan = make_plan(coarse_vessel());
  const auto& kinds = effects::catalogue();
  const auto& observers = observe::catalogue();
  ASSERT_EQ(plan.effects.size(), kinds.size() + observers.size());
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    EXPECT_EQ(plan.effects[k].name, kinds[k]->name);
    EXPECT_EQ(plan.effects[k].stage, name_of(kinds[k]->stage));
    EXPECT_FALSE(plan.effects[k].reason.empty());
  }
  for (std::size_t k = 0; k < observers.size(); ++k) {
    EXPECT_EQ(plan.effects[kinds.size() + k].name, observers[k]->name);
    EXPECT_EQ(plan.effects[kinds.size() + k].stage, "observers");
  }
}

TEST(Plan, TheSceneDecidesUnlessTheCaseSwitchesOff) {
  EXPECT_FALSE(effect(make_plan(coarse_vessel()), "bending").on);
  Case scene = coarse_vessel_with_cells();
  EXPECT_TRUE(effect(make_plan(scene), "bending").on);
  scene.effects["bending"] = Switch::automatic;
  EXPECT_TRUE(effect(make_plan(scene), "bending").on);
  scene.effects["bending"] = Switch::on;
  EXPECT_TRUE(effect(make_plan(scene), "bending").on);
  scene.effects["bending"] = Switch::off;
  const PlannedEffect off = effect(make_plan(scene), "bending");
  EXPECT_FALSE(off.on);
  EXPECT_EQ(off.pointer, "/effects/bending");
}

TEST(Plan, AllFaultsAreReportedAtOnce) {
  Case scene = coarse_vessel();
  scene.effects = {{"bending", Switch::on},   {"bendng", Switch::off},    {"inflow", Switch::off},
                   {"shifting", Switch::off}, {"contact", Switch::off},   {"membrane_coupling", Switch::off},
                   {"watch", Switch::on},     {"warp", Switch::automatic}};
  EXPECT_EQ(pointers_of_faults(scene), (std::set<std::string>{"/effects/bending", "/effects/bendng",
                                                              "/effects/inflow", "/effects/warp"}));
}

TEST(Plan, ParametersAreOfEffectsThatHaveThem) {
  Case scene = coarse_vessel_with_cells();
  scene.effects["bending"] = {Switch::on, {{"stiffness", 1}}};
  scene.effects["frames"] = {Switch::on, {{"size", 1}, {"count", 2}}};
  EXPECT_EQ(
      pointers_of_faults(scene),
      (std::set<std::string>{"/effects/bending/stiffness", "/effects/frames/size", "/effects/frames/count"}));
}

TEST(Plan, ParametersHaveTheCasesValuesOrTheirDefaults) {
  Case scene = coarse_vessel_with_cells();
  const auto stress_exponent = [&] {
    const Plan plan = make_plan(scene);
    for (const PlannedEffect::Parameter& p : effect(plan, "hemolysis").parameters) {
      if (p.name == "stress_exponent") return p.value;
    }
    return 0.0;
  };
  EXPECT_EQ(stress_exponent(), 2.416);
  scene.effects["hemolysis"] = {Switch::on, {{"stress_exponent", 2}}};
  EXPECT_EQ(stress_exponent(), 2);
}

TEST(Plan, WhatASceneNeedsCannotBeLeftOut) {
  for (const effects::EffectKind* kind : effects::catalogue()) {
    Case scene = coarse_vessel_with_cells();
    if (!kind->need(scene).called_for) continue;
    scene.effects[std::string(kind->name)] = Switch::off;
    const bool needless = !kind->need(scene).called_for;
    EXPECT_EQ(pointers_of_faults(scene).empty(), kind->optional || needless) << kind->name;
  }
}

Case published_vessel() {
  Case scene = coarse_vessel();
  scene.numerics = preset_numerics(Preset::paper);
  scene.numerics.spacing = 1e-6;
  return scene;
}

std::vector<std::string> running(const Plan& plan) {
  std::vector<std::string> names;
  for (const PlannedEffect& e : plan.effects) {
    if (e.on) names.push_back(e.name);
  }
  return names;
}

TEST(Plan, ThePublishedSchemeShowsItsEffectsAndEachChangeToIt) {
  const Plan plan = make_plan(published_vessel());
  const auto names = running(plan);
  EXPECT_THAT(names, testing::IsSupersetOf({"inflow", "outflow", "viscosity_substeps", "number_density",
                                            "density_source_relaxation", "wall_end_exclusion",
                                            "pressure_density", "gradient_from_least_pressure",
                                            "velocity_correction", "advection", "particle_motion", "watch"}));
  for (const char* accurate : {"viscosity_implicit", "inflow_flux", "pressure_rotational", "shifting",
                               "transport", "wall_clearance", "pressure_coarse_space"}) {
    EXPECT_FALSE(effect(plan, accurate).on) << accurate;
    EXPECT_EQ(effect(plan, accurate).pointer, "/numerics/preset") << accurate;
  }
  for (const char* change :
       {"density_source_relaxation", "wall_end_exclusion", "gradient_from_least_pressure"}) {
    EXPECT_THAT(effect(plan, change).reason, testing::HasSubstr("change to the published scheme"));
  }
  EXPECT_THAT(effect(plan, "viscosity_substeps").reason, testing::HasSubstr("M = 12"));
}

TEST(Plan, ChangesToThePublishedSchemeCanBeSwitchedOffAndItsCoarseSpaceOn) {
  Case scene = published_vessel();
  scene.effects = {{"density_source_relaxation", Switch::off},
                   {"wall_end_exclusion", Switch::off},
                   {"gradient_from_least_pressure", Switch::off},
                   {"pressure_coarse_space", Switch::on}};
  const Plan plan = make_plan(scene);
  EXPECT_FALSE(effect(plan, "density_source_relaxation").on);
  EXPECT_FALSE(effect(plan, "wall_end_exclusion").on);
  EXPECT_FALSE(effect(plan, "gradient_from_least_pressure").on);
  EXPECT_TRUE(effect(plan, "pressure_coarse_space").on);
  EXPECT_EQ(effect(plan, "pressure_coarse_space").pointer, "/effects/pressure_coarse_space");
}

TEST(Plan, NeitherSchemeCarriesTheOthersEffects) {
  Case scene = published_vessel();
  scene.effects = {{"shifting", Switch::on}, {"number_density", Switch::off}};
  EXPECT_EQ(pointers_of_faults(scene),
            (std::set<std::string>{"/effects/shifting", "/effects/number_density"}));
  scene = coarse_vessel();
  scene.effects = {{"pressure_coarse_space", Switch::on}, {"viscosity_substeps", Switch::on}};
  EXPECT_EQ(pointers_of_faults(scene),
            (std::set<std::string>{"/effects/pressure_coarse_space", "/effects/viscosity_substeps"}));
}

TEST(Plan, ThePublishedSchemeHasAMembraneOfItsOwn) {
  Case scene = coarse_vessel_with_cells();
  scene.numerics = preset_numerics(Preset::paper);
  scene.numerics.spacing = 1e-6;
  const Plan plan = make_plan(scene);
  const auto names = running(plan);
  EXPECT_THAT(names, testing::IsSupersetOf({"stretch", "printed_bending", "direct_forces"}));
  for (const char* accurate :
       {"bending", "contact", "membrane_coupling", "membrane_clearance", "membrane_sides", "area_control"}) {
    EXPECT_FALSE(effect(plan, accurate).on) << accurate;
    EXPECT_EQ(effect(plan, accurate).pointer, "/numerics/preset") << accurate;
  }
  for (const char* published : {"printed_bending", "direct_forces"}) {
    EXPECT_FALSE(effect(make_plan(published_vessel()), published).on) << published;
    EXPECT_FALSE(effect(make_plan(coarse_vessel_with_cells()), published).on) << published;
  }
}

TEST(Plan, SpacingFitsTheDiameter) {
  Case scene = coarse_vessel();
  for (const double wanted : {1e-6, 0.97e-6, 1.04e-6, 0.73e-6}) {
    scene.numerics.spacing = wanted;
    const double spacing = make_plan(scene).spacing;
    const double across = scene.vessel.diameter / spacing;
    EXPECT_NEAR(across, std::round(across), 1e-9);
    EXPECT_NEAR(spacing, wanted, 0.05 * wanted);
  }
}

TEST(Plan, StepsMakeUpTheDuration) {
  Case scene = coarse_vessel();
  for (const double duration : {1e-7, 2.5e-5, 4e-4, 0.0091}) {
    scene.duration = duration;
    const Plan plan = make_plan(scene);
    EXPECT_GE(plan.steps, 1);
    EXPECT_NEAR(static_cast<double>(plan.steps) * plan.time_step, duration, 1e-12 * duration);
  }
}

TEST(Plan, ANarrowerThroatTakesASmallerStep) {
  Case scene = coarse_vessel();
  scene.duration = 1;  // so that fitting the steps to it does not blur the comparison
  const double open = make_plan(scene).time_step;
  scene.thrombi = {{Wall::lower, 7e-6, 3e-6}};
  const double one = make_plan(scene).time_step;
  scene.thrombi.push_back({Wall::upper, 7e-6, 3e-6});
  const double two = make_plan(scene).time_step;
  EXPECT_NEAR(one / open, 0.7, 1e-3);
  EXPECT_NEAR(two / open, 0.4, 1e-3);
}

TEST(Plan, AFasterFlowTakesASmallerStep) {
  Case scene = coarse_vessel();
  scene.duration = 1;
  const double slow = make_plan(scene).time_step;
  scene.inflow.velocity *= 4;
  EXPECT_NEAR(make_plan(scene).time_step / slow, 0.25, 1e-3);
}

TEST(Plan, AGivenTimeStepIsKept) {
  Case scene = coarse_vessel();
  scene.numerics.time_step = 5e-6;
  const Plan exact = make_plan(scene);
  EXPECT_EQ(exact.steps, 80);
  EXPECT_DOUBLE_EQ(exact.time_step, 5e-6);
  EXPECT_NE(exact.limited_by.find("given"), std::string::npos);
  scene.numerics.time_step = 7e-6;  // does not divide the duration: never longer than asked for
  const Plan fitted = make_plan(scene);
  EXPECT_LE(fitted.time_step, 7e-6);
  EXPECT_GT(fitted.time_step, 6.8e-6);
}

TEST(Plan, CountsWhatTheSimulationThenPlaces) {
  Case scene = coarse_vessel_with_cells(2);
  scene.thrombi = {{Wall::upper, 26e-6, 2e-6}};
  const Simulation simulation(scene);
  const Plan& plan = simulation.plan();
  const auto& particles = simulation.state().particles;
  EXPECT_EQ(plan.membrane_nodes, particles.membrane_end());
  EXPECT_NEAR(plan.particles, particles.active_end(), 0.1 * plan.particles);
  EXPECT_GT(plan.wall_nodes, 2 * 30);
}

TEST(Plan, AsJsonHasThePromisedKeys) {
  const nlohmann::json json = to_json(make_plan(coarse_vessel()));
  for (const char* key :
       {"effects", "particles", "wall_nodes", "membrane_nodes", "time_step", "limited_by"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  for (const char* key : {"name", "stage", "on", "reason", "pointer"}) {
    EXPECT_TRUE(json["effects"][0].contains(key)) << key;
  }
}

TEST(Plan, FaultsOfEffectsAreReportedWithAllOthers) {
  const auto document = nlohmann::json::parse(R"({"version": 1, "vessel": {"length": 8e-5, "diameter": -1},
                                                  "effects": {"nope": "on", "watch": "off"}})");
  try {
    read_case(document, check_effects);
    FAIL() << "read without a fault";
  } catch (const CaseError& error) {
    std::vector<std::string> pointers;
    for (const Fault& fault : error.faults()) pointers.push_back(fault.pointer);
    EXPECT_THAT(pointers, testing::UnorderedElementsAre("/vessel/diameter", "/duration", "/effects/nope",
                                                        "/effects/watch"));
  }
}

}  // namespace
}  // namespace rouleau
