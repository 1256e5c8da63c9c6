#include <random>

#include <gtest/gtest.h>

#include "tests/unit/engine/case/case_samples.h"
#include "tests/unit/engine/case/key_walk.h"

namespace rouleau::testing {
namespace {

using nlohmann::json;

/// Draws documents that are sound by construction: each optional key is given or left out by chance.
class RandomCases {
 public:
  json next() {
    switch (whole(4)) {
      case 0:
        return periodic();
      case 1:
        return bifurcation();
      case 2:
        return box();
      default:
        return open();
    }
  }

 private:
  json open() {
    const double diameter = between(12e-6, 40e-6);
    json document = case_in({{"length", 200e-6}, {"diameter", diameter}});
    any_vessel(document, between(0, 200e-6), between(0, diameter));
    fed(document);
    maybe(document, "/vessel/shape", "straight");
    maybe(document, "/vessel/ends", "open");
    maybe(document, "/outflow/pressure", between(-1e3, 1e3));
    maybe(document, "/initial/flow", pick({"auto", "rest", "developed"}));
    if (whole(3) == 0) {
      document["numerics"]["preset"] = "paper";
      maybe(document, "/numerics/viscosity", "substeps");
      maybe(document, "/numerics/substeps", whole(1000) + 1);
    }
    for (int k = whole(4); k > 0; --k) document["thrombi"].push_back(thrombus(20e-6 * k));
    for (int k = whole(4); k > 0; --k) document["cells"].push_back(cell(110e-6 + 20e-6 * k, diameter / 2));
    return document;
  }

  json periodic() {
    json document = case_in({{"length", 60e-6}, {"diameter", 20e-6}, {"ends", "periodic"}});
    any_vessel(document, between(0, 60e-6), between(0, 20e-6));
    maybe(document, "/vessel/wall_velocity/lower", between(-1, 1));
    maybe(document, "/vessel/wall_velocity/upper", between(-1, 1));
    maybe(document, "/body_acceleration", {between(-1e3, 1e3), between(-1e3, 1e3)});
    maybe(document, "/initial/flow", pick({"auto", "rest", "developed"}));
    if (document["vessel"].contains("wall_velocity")) return document;
    for (int k = whole(3); k > 0; --k) document["thrombi"].push_back(thrombus(20e-6 * k));
    return document;
  }

  json bifurcation() {
    json document = bifurcation_case();
    any_vessel(document, between(0, 80e-6), between(0, 20e-6));
    fed(document);
    const auto branch = [this]() -> json {
      return {{"length", between(40e-6, 60e-6)}, {"diameter", between(8e-6, 14e-6)}};
    };
    if (whole(2) == 0) document["vessel"]["branches"] = {branch(), branch()};
    maybe(document, "/vessel/half_angle", between(20, 60));
    maybe(document, "/outflow/pressure", {between(-1e3, 1e3), between(-1e3, 1e3)});
    for (int k = whole(3); k > 0; --k) document["thrombi"].push_back(thrombus(20e-6 * k));
    for (int k = whole(2); k > 0; --k) document["cells"].push_back(cell(65e-6, 10e-6));
    return document;
  }

  json box() {
    json document = box_case();
    any_vessel(document, between(0, 30e-6), between(0, 20e-6));
    maybe(document, "/body_acceleration", {between(-1e3, 1e3), 0.0});
    if (whole(2) == 0) {
      document["vessel"]["ends"] = "periodic";
      if (whole(2) == 0) document["initial"] = {{"flow", "taylor_green"}, {"velocity", between(1e-4, 1)}};
      return document;
    }
    maybe(document, "/vessel/ends", "closed");
    for (const char* wall : {"lower", "upper", "left", "right"}) {
      maybe(document, (std::string("/vessel/wall_velocity/") + wall).c_str(), between(-1, 1));
    }
    for (int k = whole(2); k > 0; --k) document["cells"].push_back(cell(22e-6, 10e-6));
    if (document["vessel"].contains("wall_velocity")) return document;
    for (int k = whole(2); k > 0; --k) document["thrombi"].push_back(thrombus(8e-6));
    return document;
  }

  /// What every vessel takes; (x, y) is a point in it.
  void any_vessel(json& document, double x, double y) {
    document["duration"] = between(1e-5, 1);
    maybe(document, "/name", "run \"µ\" \\ " + std::to_string(whole(1000)));
    maybe(document, "/plasma/density", between(500, 2000));
    maybe(document, "/plasma/kinematic_viscosity", between(1e-7, 1e-5));
    maybe(document, "/effects/bending", pick({"auto", "on", "off"}));
    maybe(document, "/effects/shifting", pick({"auto", "on", "off"}));
    maybe(document, "/numerics/preset", pick({"draft", "standard", "fine"}));
    maybe(document, "/numerics/spacing", between(3e-7, 6e-7));
    maybe(document, "/numerics/time_step", whole(2) == 0 ? json("auto") : json(between(1e-8, 1e-5)));
    maybe(document, "/numerics/kernel_radius", between(2.6, 4));
    maybe(document, "/numerics/pressure_tolerance", between(1e-6, 1e-2));
    maybe(document, "/output/series_interval", whole(2) == 0 ? 0 : between(1e-5, 1));
    maybe(document, "/output/frame_interval", whole(2) == 0 ? 0 : between(1e-4, 1));
    maybe(document, "/output/fields", {pick({"velocity", "pressure"}), "wall_shear_stress"});
    if (whole(2) == 0) return;
    document["probes"] = {{{"name", "point"}, {"from", {x, y}}},
                          {{"name", "line-1"}, {"from", {0, 0}}, {"to", {x, y}}, {"points", 2 + whole(999)}}};
  }

  void fed(json& document) {
    maybe(document, "/inflow/velocity", between(1e-6, 1));
    maybe(document, "/inflow/profile", pick({"plug", "parabolic"}));
    maybe(document, "/inflow/waveform", {{0, between(-100, 100)}, {between(1e-6, 1), between(-100, 100)}});
  }

  json thrombus(double x) {
    return {{"wall", pick({"lower", "upper"})}, {"x", x + between(0, 1e-6)}, {"radius", between(1e-6, 5e-6)}};
  }

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
    json said = given;
    if (json& branches = said["vessel"]["branches"]; branches.is_object()) branches = json(2, branches);
    if (said["vessel"]["branches"].is_null()) said["vessel"].erase("branches");
    const json values = said.flatten();
    for (const auto& [pointer, value] : values.items()) EXPECT_EQ(kept.at(pointer), value) << pointer;
  }
}

TEST(RoundTrip, WhatIsNotGivenTakesTheDefaultOfTheTable) {
  int compared = 0;
  for (const json& given : cases_of_every_kind()) {
    for_each_said(to_json(read_case(given)),
                  [&](const Key& key, const std::string& place, const json& value) {
                    if (key.fallback.is_null() || given.contains(json::json_pointer(place))) return;
                    const bool both = key.or_pair && value.is_array();
                    EXPECT_EQ(value, both ? json(2, key.fallback) : key.fallback) << place;
                    ++compared;
                  });
  }
  EXPECT_GE(compared, 80);
}

TEST(RoundTrip, EveryChoiceOfTheTableIsKept) {
  // Those that bring keys of their own are what `cases_of_every_kind` differ in.
  const auto decides_for_others = [](const std::string& place) {
    return place == "/vessel/shape" || place == "/vessel/ends" || place == "/initial/flow" ||
           place == "/numerics/viscosity";
  };
  int tried = 0;
  for (const json& document : cases_of_every_kind()) {
    for_each_said(to_json(read_case(document)), [&](const Key& key, const std::string& place, const json&) {
      if (key.kind != Kind::choice || decides_for_others(place)) return;
      for (const std::string& choice : key.choices) {
        const json resolved = to_json(read_case(with(document, place, choice)));
        EXPECT_EQ(resolved.at(json::json_pointer(place)), choice) << place;
        ++tried;
      }
    });
  }
  EXPECT_GE(tried, 20);
  for (const json& position :
       {json("auto"), json("on"), json("off"), json{{"depth", 1e-7}, {"range", 2.0}}}) {
    const json resolved = to_json(read_case(with(minimal_case(), "/effects/bending", position)));
    EXPECT_EQ(resolved.at("effects").at("bending"), position);
  }
}

}  // namespace
}  // namespace rouleau::testing
