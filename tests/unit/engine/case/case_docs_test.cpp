#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gmock/gmock.h>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/case/case_keys.h"
#include "engine/case/vessel_outline.h"
#include "engine/case/wording.h"
#include "tests/unit/engine/case/case_samples.h"

namespace rouleau::testing {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// The text under a heading, such as "## vessel", down to the next one of its level or above.
std::string section(const std::string& page, const std::string& heading) {
  const std::size_t from = page.find("\n" + heading + "\n");
  if (from == std::string::npos) return "";
  std::size_t to = page.find("\n## ", from + 1);
  if (heading.starts_with("### ")) to = std::min(to, page.find("\n### ", from + 1));
  return page.substr(from, to - from);
}

Case example(const std::string& name) {
  return read_case(repository_file("docs/examples/" + name + ".json"));
}

/// The row of a key in its section's table.
std::string row_of(const std::string& text, const std::string& name) {
  const std::size_t from = text.find("\n| `" + name + "` |");
  return from == std::string::npos ? "" : text.substr(from, text.find('\n', from + 1) - from);
}

/// A row for each key; `prefix` is "trunk." where they are members of the trunk.
void expect_rows(const std::string& text, const std::vector<Key>& members, const std::string& prefix = "") {
  for (const Key& key : members) {
    const std::string row = row_of(text, prefix + key.name);
    ASSERT_FALSE(row.empty()) << prefix + key.name;
    EXPECT_EQ(row.find("| required |") != std::string::npos, key.required) << key.name;
    EXPECT_THAT(row, HasSubstr(key.unit)) << key.name;
    for (const std::string& choice : key.choices) {
      if (key.kind == Kind::switch_map) break;
      EXPECT_THAT(row, HasSubstr('`' + choice + '`')) << key.name;
    }
    const Kind kind = key.kind == Kind::list ? key.entries : key.kind;
    if (kind == Kind::tuple) {
      for (const Key& part : key.members) EXPECT_THAT(row, HasSubstr(part.unit)) << key.name;
    } else if (kind == Kind::object && !prefix.empty()) {
      expect_rows(text, key.members, prefix + key.name + '.');
    }
  }
}

TEST(CaseDocs, TellEveryKeyOfTheTableInItsSection) {
  const std::string page = repository_file("docs/cases.md");
  expect_rows(section(page, "## The case"), case_key().members);
  for (const Key& part : case_key().members) {
    if (part.members.empty() || part.kind == Kind::tuple) continue;
    expect_rows(section(page, "## " + part.name), part.members);
    for (const Variant& variant : part.variants) {
      const std::string text = section(page, "### " + variant.choice);
      expect_rows(text, variant.members);
      for (const Key& key : variant.members) expect_rows(text, key.members, key.name + '.');
    }
  }
}

TEST(CaseDocs, ShowTheMessagesThatTheReaderGives) {
  const std::string page = repository_file("docs/cases.md");
  const auto faults =
      faults_of(std::string_view(R"({"version": 1, "vessel": {"lenght": 80e-6, "diameter": 10e-6},
    "cells": [{"x": 16e-6, "y": 5e-6, "fill": "half"}], "duration": -1})"));
  EXPECT_EQ(faults.size(), 4U);
  for (const Fault& fault : faults)
    EXPECT_THAT(page, HasSubstr('\n' + fault.pointer + ": " + fault.message + '\n'));
}

/// The cases written out on the page.
std::vector<json> shown_cases() {
  const std::string page = repository_file("docs/cases.md");
  std::vector<json> shown;
  for (std::size_t from = page.find("```json\n"); from != std::string::npos;
       from = page.find("```json\n", from + 1)) {
    shown.push_back(json::parse(page.substr(from + 8, page.find("```", from + 8) - from - 8)));
  }
  return shown;
}

TEST(CaseDocs, TheCasesOnThePageRead) {
  const std::vector<json> shown = shown_cases();
  ASSERT_EQ(shown.size(), 4U);
  for (const json& document : shown) EXPECT_THAT(faults_of(document), ElementsAre()) << document;
  EXPECT_EQ(to_json(read_case(shown[0])), to_json(example("single_cell_8d0")));
  // The apex as the page computes it.
  EXPECT_NEAR(apex_of(read_case(shown[2]).vessel)[0], 82.7e-6, 0.05e-6);
}

TEST(CaseDocs, TellTheKnobsOfEveryPreset) {
  const std::string text = section(repository_file("docs/cases.md"), "## numerics");
  for (const char* preset : {"draft", "standard", "fine", "paper"}) {
    const json knobs = to_json(read_case(with(minimal_case(), "/numerics/preset", preset)))["numerics"];
    const auto said = [&](const char* name) -> std::string {
      const json& knob = knobs.at(name);
      if (knob.is_string()) return '`' + knob.get<std::string>() + '`';
      const std::string number = in_words(knob.get<double>());
      const std::size_t padding = number.find("e-0");
      return padding == std::string::npos ? number
                                          : number.substr(0, padding) + "e-" + number.substr(padding + 3);
    };
    EXPECT_THAT(text, HasSubstr("\n| `" + std::string(preset) + "` | " + said("spacing") + " | " +
                                said("time_step") + " | " + said("kernel_radius") + " | " +
                                said("viscosity") + " | " + said("pressure_tolerance") + " |"));
  }
}

TEST(CaseDocs, EveryExampleReadsAndIsListed) {
  const std::string page = repository_file("docs/cases.md");
  int examples = 0;
  for (const auto& file : std::filesystem::directory_iterator(repository_root() + "docs/examples")) {
    const std::string name = file.path().filename();
    // What is varied about a case, and who speaks to a service, are shown beside the cases.
    if (name.starts_with("sweep") || file.path().extension() != ".json") continue;
    EXPECT_THAT(faults_of(std::string_view(repository_file("docs/examples/" + name))), ElementsAre()) << name;
    EXPECT_THAT(page, HasSubstr("(examples/" + name + ")"));
    ++examples;
  }
  EXPECT_GE(examples, 14);
}

TEST(CaseDocs, ExamplesAreWhatTheirNamesSay) {
  for (const char* name : {"cavity_re100", "taylor_green"}) {
    const Case scene = example(name);
    const double velocity = std::max(scene.vessel.wall_velocity.upper, scene.initial.velocity);
    EXPECT_NEAR(velocity * scene.vessel.diameter / scene.plasma.kinematic_viscosity, 100, 1e-9) << name;
  }
  const Case driven = example("poiseuille_periodic");
  const double diameter = driven.vessel.diameter;
  EXPECT_NEAR(driven.body_acceleration[0] * diameter * diameter / (12 * driven.plasma.kinematic_viscosity),
              0.005, 1e-12);
  EXPECT_EQ(example("long_channel").vessel.length, 40 * example("long_channel").vessel.diameter);
  EXPECT_EQ(example("poiseuille_paper").numerics.viscosity, Viscosity::substeps);

  const Case womersley = example("womersley");
  const double period = 1e-4, steepest = 2 * std::numbers::pi / period;
  for (const auto& [time, factor] : womersley.inflow.waveform) {
    EXPECT_NEAR(factor, std::sin(steepest * time), 1e-4) << time;
  }
  EXPECT_NEAR(womersley.vessel.diameter / 2 * std::sqrt(steepest / womersley.plasma.kinematic_viscosity), 2.5,
              0.01);
}

TEST(CaseDocs, ExamplesRead) {
  const Case past_thrombus = example("single_cell_8d0");
  EXPECT_EQ(past_thrombus.name, "single cell, 8 d0 thrombus");
  EXPECT_EQ(past_thrombus.thrombi.at(0).radius, 8 * past_thrombus.numerics.spacing);
  EXPECT_EQ(past_thrombus.cells.at(0).x, 16e-6);
  EXPECT_EQ(past_thrombus.duration, 0.009);

  const Case free = example("single_cell_free");
  EXPECT_TRUE(free.thrombi.empty());
  EXPECT_EQ(free.cells.size(), 1U);

  for (const auto& [name, profile] :
       {std::pair{"poiseuille_plug", Profile::plug}, std::pair{"poiseuille_parabolic", Profile::parabolic}}) {
    const Case plasma = example(name);
    EXPECT_TRUE(plasma.thrombi.empty());
    EXPECT_TRUE(plasma.cells.empty());
    EXPECT_EQ(plasma.inflow.profile, profile);
    EXPECT_EQ(plasma.duration, 0.002);
  }
}

}  // namespace
}  // namespace rouleau::testing
