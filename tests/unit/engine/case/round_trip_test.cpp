#include <random>

#include <gtest/gtest.h>

#include "engine/case/case_keys.h"
#include "tests/unit/engine/case/case_samples.h"

namespace rouleau::testing {
namespace {

using nlohmann::json;

/// Draws documents that are sound by construction: each optional key is given or left out by chance.
class RandomCases {
 public:
  json next() {
    const double diameter = between(12e-6, 40e-6);
    json document = minimal_case();
    document["vessel"] = {{"length", 200e-6}, {"diameter", diameter}};
    document["duration"] = between(1e-5, 1);
    maybe(document, "/name", "run \"µ\" \\ " + std::to_string(whole(1000)));
    maybe(document, "/vessel/ends", "open");
    maybe(document, "/plasma/density", between(500, 2000));
    maybe(document, "/plasma/kinematic_viscosity", between(1e-7, 1e-5));
    maybe(document, "/inflow/velocity", between(1e-6, 1));
    maybe(document, "/inflow/profile", pick({"plug", "parabolic"}));
    maybe(document, "/outflow/pressure", between(-1e3, 1e3));
    maybe(document, "/effects/bending", pick({"auto", "on", "off"}));
    maybe(document, "/effects/shifting", pick({"auto", "on", "off"}));
    maybe(document, "/numerics/preset", pick({"draft", "standard", "fine"}));
    maybe(document, "/numerics/spacing", between(3e-7, 6e-7));
    maybe(document, "/numerics/time_step", whole(2) == 0 ? json("auto") : json(between(1e-8, 1e-5)));
    maybe(document, "/numerics/kernel_radius", between(2.6, 4));
    maybe(document, "/numerics/pressure_tolerance", between(1e-6, 1e-2));
    maybe(document, "/output/series_interval", whole(2) == 0 ? 0 : between(1e-5, 1));
    maybe(document, "/output/frame_interval", whole(2) == 0 ? 0 : between(1e-4, 1));
    for (int k = whole(4); k > 0; --k) {
      document["thrombi"].push_back({{"wall", pick({"lower", "upper"})},
                                     {"x", 20e-6 * k + between(0, 1e-6)},
                                     {"radius", between(1e-6, 5e-6)}});
    }
    for (int k = whole(4); k > 0; --k) document["cells"].push_back(cell(110e-6 + 20e-6 * k, diameter / 2));
    return document;
  }

 private:
  json cell(double x, double y) {
    json result = {{"x", x}, {"y", y}};
    maybe(result, "/diameter", between(5e-6, 7e-6));
    maybe(result, "/fill", between(0.45, 1));
    maybe(result, "/angle", between(-360, 360));
    maybe(result, "/stretch_modulus", between(1e-6, 1e-3));
    maybe(result, "/bend_modulus", between(1e-19, 1e-16));
    maybe(result, "/shape", "rest");
    return result;
  }

  void maybe(json& document, const char* pointer, const json& value) {
    if (whole(2) == 0) document[json::json_pointer(pointer)] = value;
  }

  double between(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random_);
  }
  int whole(int below) { return std::uniform_int_distribution<int>(0, below - 1)(random_); }
  const char* pick(const std::vector<const char*>& words) {
    return words[static_cast<std::size_t>(whole(static_cast<int>(words.size())))];
  }

  std::mt19937 random_{2};
};

TEST(RoundTrip, AResolvedCaseReadsBackAsItself) {
  RandomCases cases;
  for (int round = 0; round < 300; ++round) {
    const json given = cases.next();
    ASSERT_EQ(pointers(faults_of(given)), std::vector<std::string>()) << given;
    const json resolved = to_json(read_case(given));
    EXPECT_EQ(to_json(read_case(resolved)), resolved) << given;
    EXPECT_EQ(to_json(read_case(resolved.dump(2))).dump(), resolved.dump()) << given;
  }
}

TEST(RoundTrip, WhatWasGivenIsKept) {
  RandomCases cases;
  for (int round = 0; round < 300; ++round) {
    const json given = cases.next();
    const json kept = to_json(read_case(given)).flatten();
    const json values = given.flatten();
    for (const auto& [pointer, value] : values.items()) EXPECT_EQ(kept.at(pointer), value) << pointer;
  }
}

void expect_members(const json& value, const Key& key) {
  for (const Key& member : key.members) {
    ASSERT_TRUE(value.contains(member.name)) << member.name;
    if (member.kind == Kind::object) expect_members(value[member.name], member);
    if (member.kind == Kind::list) expect_members(value[member.name].at(0), member);
  }
  EXPECT_EQ(value.size(), key.members.size()) << value;
}

TEST(RoundTrip, AResolvedCaseSaysEveryKeyOfTheTable) {
  expect_members(to_json(read_case(published_case())), case_key());
}

void expect_defaults(const json& value, const Key& key) {
  for (const Key& member : key.members) {
    if (!member.fallback.is_null()) {
      EXPECT_EQ(value.at(member.name), member.fallback) << member.name;
    }
    if (member.kind == Kind::object) expect_defaults(value[member.name], member);
    if (member.kind == Kind::list) expect_defaults(value[member.name].at(0), member);
  }
}

TEST(RoundTrip, DefaultsAreThoseOfTheTable) {
  expect_defaults(to_json(read_case(published_case())), case_key());
}

TEST(RoundTrip, EveryChoiceOfTheTableIsKept) {
  const auto keeps = [](const char* pointer, const std::vector<std::string>& choices) {
    for (const std::string& choice : choices) {
      const json resolved = to_json(read_case(with(published_case(), pointer, choice)));
      EXPECT_EQ(resolved.at(json::json_pointer(pointer)), choice);
    }
  };
  const auto choices_of = [](const char* parent, const char* name) {
    for (const Key& part : case_key().members) {
      for (const Key& member : part.members) {
        if (part.name == parent && member.name == name) return member.choices;
      }
      if (part.name == parent && part.kind == Kind::switch_map) return part.choices;
    }
    return std::vector<std::string>{"no such key"};
  };
  keeps("/inflow/profile", choices_of("inflow", "profile"));
  keeps("/numerics/preset", choices_of("numerics", "preset"));
  keeps("/thrombi/0/wall", choices_of("thrombi", "wall"));
  keeps("/effects/bending", choices_of("effects", "bending"));
}

}  // namespace
}  // namespace rouleau::testing
