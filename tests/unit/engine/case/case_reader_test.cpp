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
  EXPECT_THAT(read.output.fields, ElementsAre(Field::velocity, Field::pressure));
  EXPECT_EQ(read.vessel.shape, Shape::straight);
  EXPECT_EQ(read.vessel.ends, Ends::open);
  EXPECT_TRUE(read.inflow.waveform.empty());
  EXPECT_EQ(read.body_acceleration, (std::array{0.0, 0.0}));
  EXPECT_EQ(read.initial.flow, InitialFlow::automatic);
  EXPECT_EQ(read.numerics.viscosity, Viscosity::implicit);
  EXPECT_EQ(read.numerics.substeps, 12);
  EXPECT_TRUE(read.probes.empty());
}

TEST(CaseReader, ReadsEveryKey) {
  const Case read = read_case(R"({"version": 1, "name": "µ", "duration": 0.002,
    "vessel": {"shape": "straight", "ends": "open", "length": 1e-4, "diameter": 2e-5},
    "plasma": {"density": 1025, "kinematic_viscosity": 1.2e-6},
    "inflow": {"velocity": 0.01, "profile": "parabolic", "waveform": [[0, 1], [0.5, -2]]},
    "outflow": {"pressure": -3}, "initial": {"flow": "rest"},
    "thrombi": [{"wall": "upper", "x": 5e-5, "radius": 4e-6}],
    "cells": [{"x": 2e-5, "y": 8e-6, "diameter": 7e-6, "fill": 0.6, "angle": -30, "stretch_modulus": 2e-5,
               "bend_modulus": 1e-18, "viscosity_ratio": 1, "shape": "circle"}],
    "effects": {"bending": "off", "contact": "auto", "x1_y": "on", "z": {"depth": 1e-7, "at_2": -3}},
    "numerics": {"preset": "draft", "spacing": 6e-7, "time_step": 1e-6, "kernel_radius": 2.6,
                 "viscosity": "implicit", "pressure_tolerance": 1e-3, "threads": 1},
    "output": {"series_interval": 0, "frame_interval": 1e-5, "fields": ["wall_shear_stress"]},
    "probes": [{"name": "across-1", "from": [4e-5, 0], "to": [4e-5, 2e-5], "points": 21},
               {"name": "point", "from": [1e-5, 1e-5]}]})");
  EXPECT_EQ(read.name, "µ");
  EXPECT_EQ(read.plasma.density, 1025);
  EXPECT_EQ(read.inflow.profile, Profile::parabolic);
  EXPECT_EQ(read.outflow.pressure[0], -3);
  EXPECT_EQ(read.thrombi.at(0).wall, Wall::upper);
  EXPECT_EQ(read.thrombi.at(0).radius, 4e-6);
  EXPECT_EQ(read.cells.at(0).fill, 0.6);
  EXPECT_EQ(read.cells.at(0).angle, -30);
  EXPECT_EQ(read.cells.at(0).shape, CellShape::circle);
  EXPECT_EQ(read.cells.at(0).bend_modulus, 1e-18);
  EXPECT_EQ(read.effects.at("bending"), Switch::off);
  EXPECT_EQ(read.effects.at("contact"), Switch::automatic);
  EXPECT_EQ(read.effects.at("x1_y"), Switch::on);
  EXPECT_EQ(read.effects.at("z"), (EffectWish{Switch::on, {{"depth", 1e-7}, {"at_2", -3}}}));
  EXPECT_EQ(read.numerics.preset, Preset::draft);
  EXPECT_EQ(read.numerics.spacing, 6e-7);
  EXPECT_EQ(read.numerics.time_step, 1e-6);
  EXPECT_EQ(read.numerics.kernel_radius, 2.6);
  EXPECT_EQ(read.output.series_interval, 0);
  EXPECT_THAT(read.output.fields, ElementsAre(Field::wall_shear_stress));
  EXPECT_EQ(read.inflow.waveform.at(1).time, 0.5);
  EXPECT_EQ(read.inflow.waveform.at(1).factor, -2);
  EXPECT_EQ(read.initial.flow, InitialFlow::rest);
  EXPECT_EQ(read.probes.at(0).name, "across-1");
  EXPECT_EQ(read.probes.at(0).to, (std::array{4e-5, 2e-5}));
  EXPECT_EQ(read.probes.at(0).points, 21);
  EXPECT_EQ(read.probes.at(1).to, read.probes.at(1).from);
  EXPECT_EQ(read.probes.at(1).points, 1);
}

TEST(CaseReader, PresetsSetTheSpacing) {
  const auto spacing = [](const char* preset) {
    return read_case(with(minimal_case(), "/numerics/preset", preset)).numerics.spacing;
  };
  EXPECT_EQ(spacing("draft"), 5e-7);
  EXPECT_EQ(spacing("standard"), 4e-7);
  EXPECT_EQ(spacing("fine"), 2.5e-7);
  EXPECT_EQ(spacing("paper"), 4e-7);
}

TEST(CaseReader, ThePaperPresetIsThePublishedScheme) {
  const Numerics published = read_case(paper_case()).numerics;
  EXPECT_EQ(published.time_step, 5e-7);
  EXPECT_EQ(published.kernel_radius, 2.1);
  EXPECT_EQ(published.viscosity, Viscosity::substeps);
  EXPECT_EQ(published.substeps, 12);
  EXPECT_EQ(published.pressure_tolerance, 1e-6);
  EXPECT_EQ(read_case(with(paper_case(), "/numerics/substeps", 7)).numerics.substeps, 7);
  EXPECT_FALSE(read_case(with(paper_case(), "/numerics/time_step", "auto")).numerics.time_step);
  EXPECT_EQ(read_case(with(paper_case(), "/numerics/kernel_radius", 1.5)).numerics.kernel_radius, 1.5);
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
  refused("/vessel/shape", "tube", "one of straight, bifurcation, box");
  refused("/vessel/ends", "closed", "one of open, periodic");
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
  refused("/cells/0/viscosity_ratio", 60, "at most 50");
  refused("/cells/0/shape", "square", "one of rest, circle");
  refused("/effects/bending", "yes", "one of auto, on, off");
  refused("/effects/bending", true, "one of auto, on, off");
  refused("/effects/Bending", "on", "lower-case words");
  refused("/numerics/preset", "coarse", "one of draft, standard, fine, paper");
  refused("/numerics/spacing", 0, "greater than 0");
  refused("/numerics/kernel_radius", 1.4, "at least 1.5 and at most 4");
  refused("/numerics/viscosity", "explicit", "one of implicit, substeps");
  refused("/numerics/substeps", 0, "a whole number of at least 1 and at most 1000");
  refused("/inflow/waveform", 1, "a list of at most 10000 lists [time (s), factor]");
  refused("/initial/flow", "still", "one of auto, rest, developed, taylor_green");
  refused("/body_acceleration", {1}, "a list [ax (m/s2), ay (m/s2)]");
  refused("/numerics/pressure_tolerance", 0, "at least");
  refused("/numerics/threads", 2, "equal to 1");
  refused("/numerics/time_step", 0, "(s)");
  refused("/duration", 0, "greater than 0");
  refused("/output/series_interval", -1e-5, "or 0 for none");
  refused("/output/frame_interval", 1e-13, "1e-12");
  refused("/duration", std::numeric_limits<double>::quiet_NaN(), "nan");
  refused("/duration", std::numeric_limits<double>::infinity(), "inf");
}

TEST(CaseReader, NamesTheEntryThatIsWrong) {
  expect_only_fault(with(minimal_case(), "/inflow/waveform", {{0, 1}, {1}}), "/inflow/waveform/1",
                    "found a list of 1; allowed is a list [time (s), factor]");
  expect_only_fault(with(minimal_case(), "/inflow/waveform", {{0, 1}, {-1, 1}}), "/inflow/waveform/1/0",
                    "of at least 0");
  expect_only_fault(with(minimal_case(), "/inflow/waveform", {{0, 101}}), "/inflow/waveform/0/1",
                    "at most 100");
  expect_only_fault(with(minimal_case(), "/output/fields", {"velocity", "speed"}), "/output/fields/1",
                    "one of velocity, pressure, wall_shear_stress");
  expect_only_fault(with(minimal_case(), "/output/fields", {"velocity", "velocity"}), "/output/fields/1",
                    "found the text \"velocity\" again");
  expect_only_fault(with(minimal_case(), "/probes", {{{"name", "a b"}, {"from", {0, 0}}}}), "/probes/0/name",
                    "found the text \"a b\"; allowed is a text of at most 64 letters, digits, _ and -");
  expect_only_fault(with(minimal_case(), "/probes", {{{"name", "a"}, {"from", {0, "0"}}}}),
                    "/probes/0/from/1", "allowed is a number");
  expect_only_fault(with(bifurcation_case(), "/vessel/branches",
                         {{{"length", 40e-6}, {"diameter", 0}}, {{"length", 40e-6}, {"diameter", 10e-6}}}),
                    "/vessel/branches/0/diameter", "greater than 0");
  expect_only_fault(with(bifurcation_case(), "/vessel/branches", json::array({1})), "/vessel/branches",
                    "an object, or a list of two of these");
}

TEST(CaseReader, BoundsTheNumberOfThings) {
  expect_only_fault(with(minimal_case(), "/probes", json(33, json::object())), "/probes", "at most 32");
  expect_only_fault(with(minimal_case(), "/inflow/waveform", json(10'001, {0, 1})), "/inflow/waveform",
                    "at most 10000");
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
  expect_only_fault(document, "/vessel/lenght", "did you mean \"length\"? allowed here: shape, length");
  expect_only_fault(with(minimal_case(), "/a~1b", 1), "/a~1b", "unknown key; allowed here: version, name");
  expect_only_fault(with(minimal_case(), "/inflow/ramp", json::array()), "/inflow/ramp", "unknown key;");
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
