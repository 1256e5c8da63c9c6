#include <cmath>
#include <gmock/gmock.h>
#include <limits>

#include <gtest/gtest.h>

#include "engine/case/faults.h"
#include "tests/unit/engine/case/case_samples.h"

namespace rouleau::testing {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::WhenSorted;

void expect_only_fault(const json& document, const std::string& pointer, const std::string& message) {
  const std::vector<Fault> faults = faults_of(document);
  ASSERT_THAT(pointers(faults), ElementsAre(pointer)) << document;
  EXPECT_THAT(faults[0].message, HasSubstr(message)) << document;
}

TEST(CaseReader, FillsInEveryDefault) {
  const Case read = read_case(minimal_case());
  EXPECT_EQ(read.name, "");
  EXPECT_EQ(read.vessel.length, 80e-6);
  EXPECT_EQ(read.vessel.diameter, 10e-6);
  EXPECT_EQ(read.plasma.density, 1000);
  EXPECT_EQ(read.plasma.kinematic_viscosity, 1e-6);
  EXPECT_EQ(read.inflow.velocity, 0.005);
  EXPECT_EQ(read.inflow.profile, Profile::plug);
  EXPECT_EQ(read.outflow.pressure[0], 0);
  EXPECT_TRUE(read.thrombi.empty());
  EXPECT_TRUE(read.cells.empty());
  EXPECT_TRUE(read.effects.empty());
  EXPECT_EQ(read.numerics.spacing, 4e-7);
  EXPECT_EQ(read.numerics.kernel_radius, 3.1);
  EXPECT_EQ(read.numerics.pressure_tolerance, 1e-2);
  EXPECT_FALSE(read.numerics.time_step);
  EXPECT_EQ(read.duration, 1e-3);
  EXPECT_EQ(read.output.series_interval, 2e-5);
  EXPECT_EQ(read.output.frame_interval, 1e-4);
}

TEST(CaseReader, ReadsEveryKey) {
  const Case read = read_case(R"({"version": 1, "name": "µ", "duration": 0.002,
    "vessel": {"shape": "straight", "ends": "open", "length": 1e-4, "diameter": 2e-5},
    "plasma": {"density": 1025, "kinematic_viscosity": 1.2e-6},
    "inflow": {"velocity": 0.01, "profile": "parabolic"}, "outflow": {"pressure": -3},
    "thrombi": [{"wall": "upper", "x": 5e-5, "radius": 4e-6}],
    "cells": [{"x": 2e-5, "y": 8e-6, "diameter": 7e-6, "fill": 0.6, "angle": -30, "stretch_modulus": 2e-5,
               "bend_modulus": 1e-18, "viscosity_ratio": 1, "shape": "rest"}],
    "effects": {"bending": "off", "contact": "auto", "x1_y": "on"},
    "numerics": {"preset": "draft", "spacing": 6e-7, "time_step": 1e-6, "kernel_radius": 2.6,
                 "pressure_tolerance": 1e-3, "threads": 1},
    "output": {"series_interval": 0, "frame_interval": 1e-5}})");
  EXPECT_EQ(read.name, "µ");
  EXPECT_EQ(read.plasma.density, 1025);
  EXPECT_EQ(read.inflow.profile, Profile::parabolic);
  EXPECT_EQ(read.outflow.pressure[0], -3);
  EXPECT_EQ(read.thrombi.at(0).wall, Wall::upper);
  EXPECT_EQ(read.thrombi.at(0).radius, 4e-6);
  EXPECT_EQ(read.cells.at(0).fill, 0.6);
  EXPECT_EQ(read.cells.at(0).angle, -30);
  EXPECT_EQ(read.cells.at(0).bend_modulus, 1e-18);
  EXPECT_EQ(read.effects.at("bending"), Switch::off);
  EXPECT_EQ(read.effects.at("contact"), Switch::automatic);
  EXPECT_EQ(read.effects.at("x1_y"), Switch::on);
  EXPECT_EQ(read.numerics.preset, Preset::draft);
  EXPECT_EQ(read.numerics.spacing, 6e-7);
  EXPECT_EQ(read.numerics.time_step, 1e-6);
  EXPECT_EQ(read.numerics.kernel_radius, 2.6);
  EXPECT_EQ(read.output.series_interval, 0);
}

TEST(CaseReader, PresetsSetTheSpacing) {
  const auto spacing = [](const char* preset) {
    return read_case(with(minimal_case(), "/numerics/preset", preset)).numerics.spacing;
  };
  EXPECT_EQ(spacing("draft"), 5e-7);
  EXPECT_EQ(spacing("standard"), 4e-7);
  EXPECT_EQ(spacing("fine"), 2.5e-7);
}

TEST(CaseReader, RefusesValuesOfTheWrongType) {
  expect_only_fault(with(minimal_case(), "/version", 3.9), "/version",
                    "found the number 3.9; allowed is a whole");
  expect_only_fault(with(minimal_case(), "/version", -1), "/version", "found the number -1");
  expect_only_fault(with(minimal_case(), "/version", 2), "/version", "equal to 1");
  expect_only_fault(with(minimal_case(), "/version", true), "/version", "found true");
  expect_only_fault(with(minimal_case(), "/version", 4294967297), "/version", "4294967297");
  expect_only_fault(with(minimal_case(), "/duration", "1"), "/duration", "found the text \"1\"");
  expect_only_fault(with(minimal_case(), "/duration", nullptr), "/duration", "found null");
  expect_only_fault(with(minimal_case(), "/duration", {1}), "/duration", "found a list");
  expect_only_fault(with(minimal_case(), "/numerics/threads", 1.5), "/numerics/threads", "whole number");
  expect_only_fault(with(minimal_case(), "/numerics/time_step", "often"), "/numerics/time_step",
                    "or \"auto\"");
  expect_only_fault(with(minimal_case(), "/duration", "auto"), "/duration", "found the text \"auto\"");
  expect_only_fault(with(minimal_case(), "/vessel", 3), "/vessel", "allowed is an object");
  expect_only_fault(with(minimal_case(), "/cells", json::object()), "/cells", "allowed is a list");
  expect_only_fault(with(minimal_case(), "/cells", {1}), "/cells/0", "allowed is an object");
  expect_only_fault(with(minimal_case(), "/name", 7), "/name", "allowed is a text");
  expect_only_fault(with(minimal_case(), "/name", "\x1b[31m"), "/name", "control characters");
  expect_only_fault(with(minimal_case(), "/name", std::string(201, 'x')), "/name", "at most 200");
  EXPECT_NO_THROW(read_case(with(minimal_case(), "/version", 1.0)));
}

TEST(CaseReader, RefusesValuesOutOfRange) {
  const auto refused = [](const char* pointer, const json& value, const char* message) {
    expect_only_fault(with(published_case(), pointer, value), pointer, message);
  };
  refused("/vessel/length", 0, "greater than 0 and less than 1 (m)");
  refused("/vessel/diameter", 1, "less than 1 (m)");
  refused("/vessel/shape", "box", "allowed is only \"straight\"");
  refused("/vessel/ends", "periodic", "allowed is only \"open\"");
  refused("/plasma/density", 0, "(kg/m3)");
  refused("/plasma/kinematic_viscosity", -1e-6, "(m2/s)");
  refused("/inflow/velocity", 0, "greater than 0");
  refused("/inflow/velocity", -0.005, "found the number -0.005");
  refused("/inflow/profile", "flat", "one of plug, parabolic");
  refused("/outflow/pressure", 1e7, "(Pa)");
  refused("/thrombi/0/wall", "left", "one of lower, upper");
  refused("/thrombi/0/radius", -1, "greater than 0");
  refused("/cells/0/fill", 1.01, "at most 1");
  refused("/cells/0/fill", 0.2, "at least 0.3");
  refused("/cells/0/angle", 400, "(degrees)");
  refused("/cells/0/stretch_modulus", 0, "(N/m)");
  refused("/cells/0/bend_modulus", 0, "(J)");
  refused("/cells/0/viscosity_ratio", 5, "equal to 1");
  refused("/cells/0/shape", "circle", "only \"rest\"");
  refused("/effects/bending", "yes", "one of auto, on, off");
  refused("/effects/bending", true, "one of auto, on, off");
  refused("/effects/Bending", "on", "lower-case words");
  refused("/numerics/preset", "paper", "one of draft, standard, fine");
  refused("/numerics/spacing", 0, "greater than 0");
  refused("/numerics/kernel_radius", 2.1, "at least 2.6 and at most 4");
  refused("/numerics/pressure_tolerance", 0, "at least");
  refused("/numerics/threads", 2, "equal to 1");
  refused("/numerics/time_step", 0, "(s)");
  refused("/duration", 0, "greater than 0");
  refused("/output/series_interval", -1e-5, "or 0 for none");
  refused("/output/frame_interval", 1e-13, "1e-12");
  refused("/duration", std::numeric_limits<double>::quiet_NaN(), "nan");
  refused("/duration", std::numeric_limits<double>::infinity(), "inf");
}

TEST(CaseReader, BoundsTheNumberOfThings) {
  expect_only_fault(with(minimal_case(), "/thrombi", json(65, json::object())), "/thrombi", "at most 64");
  expect_only_fault(with(minimal_case(), "/cells", json(65, json::object())), "/cells", "found a list of 65");
  json effects;
  for (int k = 0; k < 65; ++k) effects["effect" + std::to_string(k)] = "on";
  expect_only_fault(with(minimal_case(), "/effects", effects), "/effects", "at most 64");
}

TEST(CaseReader, NamesWhatIsMissing) {
  EXPECT_THAT(pointers(faults_of(json::object())),
              WhenSorted(ElementsAre("/duration", "/version", "/vessel")));
  json document = minimal_case();
  document["vessel"].erase("length");
  expect_only_fault(document, "/vessel/length", "missing");
  document = minimal_case();
  document["thrombi"] = {json::object()};
  document["cells"] = {json::object()};
  EXPECT_THAT(pointers(faults_of(document)),
              WhenSorted(ElementsAre("/cells/0/x", "/cells/0/y", "/thrombi/0/radius", "/thrombi/0/wall",
                                     "/thrombi/0/x")));
}

TEST(CaseReader, RefusesUnknownKeysAndSaysWhatIsKnown) {
  json document = minimal_case();
  document["vessel"]["lenght"] = 1;
  expect_only_fault(document, "/vessel/lenght", "did you mean \"length\"? allowed here: shape, ends, length");
  expect_only_fault(with(minimal_case(), "/a~1b", 1), "/a~1b", "unknown key; allowed here: version, name");
  expect_only_fault(with(minimal_case(), "/body_acceleration", {1, 0}), "/body_acceleration", "unknown key;");
  expect_only_fault(with(minimal_case(), "/inflow/waveform", json::array()), "/inflow/waveform",
                    "unknown key");
  expect_only_fault(with(published_case(), "/cells/0/Angle", 1), "/cells/0/Angle", "did you mean \"angle\"?");
}

TEST(CaseReader, RefusesWhatIsNoObject) {
  for (const char* text : {"[]", "3", "null", "\"{}\""}) {
    EXPECT_THAT(pointers(faults_of(std::string_view(text))), ElementsAre("")) << text;
  }
}

TEST(CaseReader, ReportsAllFaultsAtOnceDuplicatesAndSceneIncluded) {
  const std::vector<Fault> faults = faults_of(std::string_view(R"({"version": "1", "colour": 1,
    "vessel": {"length": 80e-6, "diameter": 10e-6}, "inflow": {"velocity": 1, "velocity": -1},
    "cells": [{"x": 16e-6, "y": 1e-6}, {"x": "far", "y": 5e-6}, {"x": 1e-6, "y": 5e-6}], "duration": -2})"));
  EXPECT_THAT(pointers(faults),
              WhenSorted(ElementsAre("/cells/0", "/cells/1/x", "/cells/2", "/colour", "/duration",
                                     "/inflow/velocity", "/inflow/velocity", "/version")));
  try {
    read_case(minimal_case().dump() + "!");
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_THAT(error.what(), HasSubstr("the whole case: line 1"));
  }
}

TEST(CaseReader, WhatListsAllFaultsOneALine) {
  const CaseError error({{"/a", "one"}, {"", "two"}});
  EXPECT_STREQ(error.what(), "/a: one\nthe whole case: two");
}

TEST(CaseReader, RepeatsNoEndlessInput) {
  json document = minimal_case();
  document["inflow"]["profile"] = std::string(500'000, 'p');
  for (int k = 0; k < 5000; ++k) document["key" + std::to_string(k)] = k;
  const std::vector<Fault> faults = faults_of(document);
  EXPECT_EQ(faults.size(), max_listed_faults + 1);
  for (const Fault& fault : faults) EXPECT_LT(fault.message.size(), 400U);
}

}  // namespace
}  // namespace rouleau::testing
