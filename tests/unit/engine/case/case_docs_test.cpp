#include <gmock/gmock.h>

#include <gtest/gtest.h>

#include "engine/case/case_keys.h"
#include "tests/unit/engine/case/case_samples.h"

namespace rouleau::testing {
namespace {

using ::testing::HasSubstr;

std::string section(const std::string& page, const std::string& title) {
  const std::size_t from = page.find("\n## " + title + "\n");
  if (from == std::string::npos) return "";
  return page.substr(from, page.find("\n## ", from + 1) - from);
}

Case example(const std::string& name) {
  return read_case(repository_file("docs/examples/" + name + ".json"));
}

/// The row of a key in its section's table.
std::string row_of(const std::string& text, const Key& key) {
  const std::size_t from = text.find("\n| `" + key.name + "` |");
  return from == std::string::npos ? "" : text.substr(from, text.find('\n', from + 1) - from);
}

void expect_rows(const std::string& text, const Key& object) {
  for (const Key& key : object.members) {
    const std::string row = row_of(text, key);
    ASSERT_FALSE(row.empty()) << key.name;
    EXPECT_EQ(row.find("| required |") != std::string::npos, key.required) << key.name;
    EXPECT_THAT(row, HasSubstr(key.unit)) << key.name;
    if (key.kind != Kind::choice) continue;
    for (const std::string& choice : key.choices) EXPECT_THAT(row, HasSubstr('`' + choice + '`')) << key.name;
  }
}

TEST(CaseDocs, TellEveryKeyOfTheTableInItsSection) {
  const std::string page = repository_file("docs/cases.md");
  expect_rows(section(page, "The case"), case_key());
  for (const Key& part : case_key().members) {
    if (part.members.empty()) continue;
    expect_rows(section(page, part.name), part);
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

TEST(CaseDocs, TheFirstExampleOnThePageReads) {
  const std::string page = repository_file("docs/cases.md");
  const std::size_t from = page.find("```json\n") + 8;
  const Case shown = read_case(page.substr(from, page.find("```", from) - from));
  EXPECT_EQ(to_json(shown), to_json(example("single_cell_8d0")));
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
