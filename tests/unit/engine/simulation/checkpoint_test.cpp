#include "engine/simulation/checkpoint.h"

#include <algorithm>
#include <bit>
#include <gmock/gmock.h>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/error/checkpoint_error.h"
#include "engine/error/simulation_error.h"
#include "tests/unit/engine/simulation/recorder.h"
#include "tests/unit/engine/simulation/same_particles.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau {
namespace {

/// Keeps a checkpoint before every step.
struct Checkpoints : Recorder {
  std::vector<Checkpoint> kept;
  void checkpoint(const Checkpoint& checkpoint) override { kept.push_back(checkpoint); }
};

constexpr double every_step = 1e-12;

/// One that leaves in the course of it, behind which another comes.
Case vessel_that_a_cell_leaves() {
  Case scene = coarse_vessel_with_cells(2);
  scene.vessel.length = 26e-6;
  scene.duration = 1.2e-3;
  scene.probes.push_back({"line", {5e-6, 0}, {5e-6, 10e-6}, 5});
  scene.output.fields.push_back(Field::wall_shear_stress);
  return scene;
}

std::vector<std::uint64_t> bits(const std::vector<double>& values) {
  std::vector<std::uint64_t> found;
  for (const double value : values) found.push_back(std::bit_cast<std::uint64_t>(value));
  return found;
}

/// What a run from a checkpoint delivers is the end of what the whole run did.
void expect_the_rest(const Recorder& whole, const Recorder& rest, const CheckpointHead& head) {
  ASSERT_EQ(rest.rows.size() + static_cast<std::size_t>(head.rows), whole.rows.size());
  ASSERT_EQ(rest.frames.size() + static_cast<std::size_t>(head.frames), whole.frames.size());
  for (std::size_t k = 0; k < rest.rows.size(); ++k) {
    const std::size_t at = k + static_cast<std::size_t>(head.rows);
    EXPECT_EQ(bits(rest.rows[k]), bits(whole.rows[at])) << k;
    if (whole.probe_rows.empty()) continue;
    EXPECT_EQ(rest.probe_times[k], whole.probe_times[at]);
    EXPECT_EQ(bits(rest.probe_rows[k][0].u), bits(whole.probe_rows[at][0].u));
    EXPECT_EQ(bits(rest.probe_rows[k][0].p), bits(whole.probe_rows[at][0].p));
  }
  for (std::size_t k = 0; k < rest.frames.size(); ++k) {
    const Frame& one = rest.frames[k];
    const Frame& other = whole.frames[k + static_cast<std::size_t>(head.frames)];
    EXPECT_EQ(one.step, other.step);
    expect_same_particles(one, other);
    EXPECT_EQ(one.wall_shear_stress, other.wall_shear_stress);
    EXPECT_EQ(one.membrane_fields, other.membrane_fields);
  }
  EXPECT_EQ(rest.header.capacity, whole.header.capacity);
}

void expect_resumed_bit_for_bit(const Case& scene) {
  Checkpoints whole;
  const RunSummary summary = run_case(scene, whole, {}, {nullptr, every_step});
  Recorder undisturbed;
  run_case(scene, undisturbed);
  ASSERT_EQ(undisturbed.rows.size(), whole.rows.size());
  EXPECT_EQ(bits(undisturbed.rows.back()), bits(whole.rows.back()));
  ASSERT_GE(whole.kept.size(), 10u);
  std::mt19937 random(20261122);
  for (int trial = 0; trial < 6; ++trial) {
    const Checkpoint& from = whole.kept[random() % whole.kept.size()];
    const CheckpointHead head = head_of(from, scene);
    Recorder rest;
    const RunSummary resumed = run_case(scene, rest, {}, {&from, 0});
    EXPECT_EQ(timeless(to_json(resumed)), timeless(to_json(summary))) << "from step " << head.steps;
    expect_the_rest(whole, rest, head);
  }
}

TEST(Checkpoint, PlasmaWithOpenEndsGoesOnBitForBit) {
  Case scene = coarse_vessel();
  scene.inflow.waveform = {{0, 1}, {1e-4, -1}, {3e-4, 1.5}};
  expect_resumed_bit_for_bit(scene);
}

TEST(Checkpoint, CellsGoOnBitForBitAndLeave) {
  const Case scene = vessel_that_a_cell_leaves();
  Recorder recorder;
  ASSERT_TRUE(run_case(scene, recorder).cells[1].departure);
  expect_resumed_bit_for_bit(scene);
}

TEST(Checkpoint, InextensibleCellsGoOnBitForBitAndLeave) {
  Case scene = vessel_that_a_cell_leaves();
  scene.effects["inextensible"] = Switch::on;
  Recorder recorder;
  ASSERT_TRUE(run_case(scene, recorder).cells[1].departure);
  expect_resumed_bit_for_bit(scene);
}

TEST(Checkpoint, OptionalOutputsGoOnBitForBit) {
  Case scene = vessel_that_a_cell_leaves();
  scene.probes.clear();
  for (const char* output :
       {"hydraulic_resistance", "cell_free_layer", "fahraeus", "membrane_maps", "hemolysis"}) {
    scene.effects[output] = {Switch::on};
  }
  expect_resumed_bit_for_bit(scene);
}

TEST(Checkpoint, TheOneWrittenWhenStoppedIsTheLastState) {
  struct Stopping : Checkpoints {
    std::stop_source source;
    void frame(const Frame& frame) override {
      Recorder::frame(frame);
      if (frames.size() == 3) source.request_stop();
    }
  } first;
  Recorder rest, whole;
  const Case scene = coarse_vessel_with_cells();
  run_case(scene, first, first.source.get_token(), {nullptr, 3600});
  ASSERT_EQ(first.kept.size(), 1u);
  const CheckpointHead head = head_of(first.kept[0], scene);
  EXPECT_EQ(head.frames, 3);
  EXPECT_EQ(head.rows, static_cast<long>(first.rows.size()));
  run_case(scene, rest, {}, {&first.kept[0], 0});
  run_case(scene, whole);
  expect_the_rest(whole, rest, head);
}

Checkpoint one_of(const Case& scene) {
  Checkpoints recorder;
  run_case(scene, recorder, {}, {nullptr, every_step});
  return recorder.kept.at(recorder.kept.size() / 2);
}

TEST(Checkpoint, OfAnotherCaseIsRefused) {
  const Case scene = coarse_vessel();
  Case other = scene;
  other.inflow.velocity *= 1 + 1e-15;
  const Checkpoint checkpoint = one_of(scene);
  Recorder recorder;
  EXPECT_NO_THROW(head_of(checkpoint, scene));
  EXPECT_THROW(head_of(checkpoint, other), CheckpointError);
  EXPECT_THROW(run_case(other, recorder, {}, {&checkpoint, 0}), CheckpointError);
}

/// What is said of a checkpoint that nothing goes on from.
std::string refusal(const Checkpoint& checkpoint, const Case& scene) {
  Recorder recorder;
  try {
    run_case(scene, recorder, {}, {&checkpoint, 0});
  } catch (const CheckpointError& error) {
    EXPECT_TRUE(recorder.rows.empty());
    EXPECT_THROW(head_of(checkpoint, scene), CheckpointError);
    return error.what();
  }
  return "";
}

TEST(Checkpoint, OfAnotherVersionOrFormatIsRefused) {
  const Case scene = coarse_vessel();
  const Checkpoint checkpoint = one_of(scene);
  const std::string version = engine_version();
  const auto is_version = [&](std::byte byte, char letter) { return byte == static_cast<std::byte>(letter); };
  const auto at = std::search(checkpoint.bytes.begin(), checkpoint.bytes.end(), version.begin(),
                              version.end(), is_version) -
                  checkpoint.bytes.begin();
  ASSERT_LT(at, 64) << "the version stands at its head";

  Checkpoint other = checkpoint;
  other.bytes[static_cast<std::size_t>(at)] = std::byte{'9'};
  std::string other_version = version;
  other_version[0] = '9';
  EXPECT_THAT(refusal(other, scene), testing::AllOf(testing::HasSubstr("version " + other_version + ","),
                                                    testing::HasSubstr("this is " + version)));

  constexpr std::size_t format = sizeof(std::uint64_t);  // behind the mark
  other = checkpoint;
  other.bytes[format] = std::byte{77};
  EXPECT_THAT(refusal(other, scene), testing::HasSubstr("format 77"));

  std::reverse(other.bytes.begin(), other.bytes.begin() + format);
  EXPECT_THAT(refusal(other, scene), testing::HasSubstr("kind of machine"));
  EXPECT_EQ(refusal(checkpoint, scene), "");
}

TEST(Checkpoint, CutOffAnywhereIsRefused) {
  const Case scene = coarse_vessel_with_cells();
  const Checkpoint whole = one_of(scene);
  Recorder recorder;
  for (std::size_t kept = 0; kept < whole.bytes.size(); kept += 1 + whole.bytes.size() / 40) {
    Checkpoint cut = whole;
    cut.bytes.resize(kept);
    EXPECT_THROW(run_case(scene, recorder, {}, {&cut, 0}), CheckpointError) << kept;
  }
  Checkpoint longer = whole;
  longer.bytes.push_back(std::byte{0});
  EXPECT_THROW(run_case(scene, recorder, {}, {&longer, 0}), CheckpointError);
}

// A file with a right checksum may still hold anything.
TEST(Checkpoint, WhateverItSaysARunEndsInOrder) {
  const Case scene = coarse_vessel_with_cells();
  const Checkpoint whole = one_of(scene);
  std::mt19937 random(7);
  int refused = 0;
  for (int trial = 0; trial < 60; ++trial) {
    Checkpoint changed = whole;
    for (int k = 0; k < 4; ++k) {
      const std::size_t at = random() % changed.bytes.size();
      changed.bytes[at] = static_cast<std::byte>(random());
    }
    Recorder recorder;
    try {
      run_case(scene, recorder, {}, {&changed, 0});
    } catch (const CheckpointError&) {
      ++refused;
    } catch (const SimulationError&) {
    }
  }
  EXPECT_GT(refused, 5);
}

}  // namespace
}  // namespace rouleau
