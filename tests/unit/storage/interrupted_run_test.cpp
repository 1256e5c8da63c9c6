#include "storage/interrupted_run.h"

#include <bit>
#include <fstream>
#include <iterator>
#include <random>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "engine/error/checkpoint_error.h"
#include "engine/simulation/run.h"
#include "storage/archive.h"
#include "storage/checkpoint_file.h"
#include "tests/unit/engine/simulation/recorder.h"
#include "tests/unit/engine/simulation/same_particles.h"
#include "tests/unit/engine/simulation/scenes.h"
#include "tests/unit/storage/child_process.h"
#include "tests/unit/storage/scratch.h"

namespace rouleau::storage {
namespace {

/// Writes an archive, checkpoints before every step, and tells of each.
class Writing : public Output {
 public:
  Writing(const std::filesystem::path& archive, const Case& scene, const ChildProcess::Tell& tell)
      : writer_(archive, to_json(scene).dump()), keeper_(archive), tell_(tell) {}

  void begin(const RunHeader& header) override {
    writer_.begin(header);
    if (resumed_) resumed_->begin(header);
  }
  void series_row(std::span<const double> row) override { writer_.series_row(row); }
  void probe_row(double time, std::span<const ProbeValues> row) override { writer_.probe_row(time, row); }
  void frame(const Frame& frame) override { writer_.frame(frame); }
  void checkpoint(const Checkpoint& checkpoint) override {
    writer_.checkpoint(checkpoint);
    keeper_.checkpoint(checkpoint);
    if (tell_) tell_("checkpoint");
  }

  void run(const Case& scene, const std::filesystem::path& archive) {
    const auto interrupted = find_interrupted(archive, scene);
    if (interrupted) resumed_.emplace(*interrupted, writer_);
    const RunSummary summary =
        run_case(scene, *this, {}, {interrupted ? &interrupted->checkpoint : nullptr, 1e-12});
    writer_.finish(summary);
    keeper_.remove();
  }

 private:
  ArchiveWriter writer_;
  CheckpointKeeper keeper_;
  std::optional<ResumedOutput> resumed_;
  ChildProcess::Tell tell_;
};

void run_to_the_end(const std::filesystem::path& archive, const Case& scene,
                    const ChildProcess::Tell& tell = {}) {
  Writing(archive, scene, tell).run(scene, archive);
}

template <class Real>
void expect_same_bits(const std::vector<Real>& one, const std::vector<Real>& other, const std::string& what) {
  ASSERT_EQ(one.size(), other.size()) << what;
  using Bits = std::conditional_t<sizeof(Real) == 8, std::uint64_t, std::uint32_t>;
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ(std::bit_cast<Bits>(one[i]), std::bit_cast<Bits>(other[i])) << what << ", " << i;
  }
}

void expect_same_archive(const std::filesystem::path& one_path, const std::filesystem::path& other_path) {
  const ArchiveReader one(one_path), other(other_path);
  const SeriesTable series = one.series(), expected = other.series();
  ASSERT_EQ(series.columns.size(), expected.columns.size());
  for (std::size_t c = 0; c < series.columns.size(); ++c) {
    expect_same_bits(series.values[c], expected.values[c], series.columns[c].name);
  }
  for (const std::string& name : one.probe_names()) {
    expect_same_bits(one.probe(name).u, other.probe(name).u, name);
    expect_same_bits(one.probe(name).flux, other.probe(name).flux, name);
  }
  ASSERT_EQ(one.frame_count(), other.frame_count());
  for (int k = 0; k < one.frame_count(); ++k) {
    const Frame a = one.frame(k), b = other.frame(k);
    EXPECT_EQ(a.kind, b.kind);
    expect_same_particles(a, b);
    expect_same_bits(a.wall_shear_stress, b.wall_shear_stress, "wall shear stress");
    for (std::size_t c = 0; c < one.outlines(k).size(); ++c) {
      expect_same_bits(one.outlines(k)[c].x, other.outlines(k)[c].x, "outline");
    }
  }
  EXPECT_EQ(timeless(one.summary()), timeless(other.summary()));
}

/// Kills the run at some moment after each few checkpoints, until it gets to its end.
void expect_nothing_of_it_seen(const Case& scene, unsigned seed) {
  const ScratchFolder folder;
  const auto killed = folder.path() / "killed.h5", whole = folder.path() / "whole.h5";
  run_to_the_end(whole, scene);
  std::mt19937 random(seed);
  int kills = 0;
  for (;; ++kills) {
    ASSERT_LT(kills, 100);
    ChildProcess child([&](const ChildProcess::Tell& tell) { run_to_the_end(killed, scene, tell); });
    std::string line = "checkpoint";
    for (auto k = 8 + random() % 12; k > 0 && line == "checkpoint"; --k) line = child.read_line();
    if (line.empty()) {
      EXPECT_EQ(child.wait(), 0);
      break;
    }
    ASSERT_EQ(line, "checkpoint");
    usleep(static_cast<useconds_t>(random() % 3000));
    child.kill();
  }
  EXPECT_GE(kills, 3);
  expect_same_archive(killed, whole);
  EXPECT_FALSE(std::filesystem::exists(checkpoint_path(killed)));
  EXPECT_FALSE(std::filesystem::exists(unfinished_path(killed)));
}

TEST(InterruptedRun, PlasmaKilledAgainAndAgainGivesTheSameArchive) {
  Case scene = coarse_vessel();
  scene.duration = 8e-4;
  scene.numerics.spacing = 0.8e-6;
  scene.output.fields.push_back(Field::wall_shear_stress);
  scene.probes.push_back({"line", {5e-6, 0}, {5e-6, 10e-6}, 5});
  expect_nothing_of_it_seen(scene, 1);
}

TEST(InterruptedRun, CellsKilledAgainAndAgainGiveTheSameArchive) {
  Case scene = coarse_vessel_with_cells(2);
  scene.vessel.length = 26e-6;
  scene.duration = 1.2e-3;
  expect_nothing_of_it_seen(scene, 2);
}

class Stopped : public testing::Test {
 protected:
  Stopped() {
    struct AtOnce : Output {
      std::optional<Checkpoint> kept;
      void checkpoint(const Checkpoint& checkpoint) override { kept = checkpoint; }
    } output;
    std::stop_source stop;
    stop.request_stop();
    run_case(scene, output, stop.get_token(), {nullptr, 1});
    checkpoint = *output.kept;
  }

  ScratchFolder folder;
  std::filesystem::path archive = folder.path() / "out.h5";
  Case scene = coarse_vessel();
  Checkpoint checkpoint;
};

TEST_F(Stopped, WithoutACheckpointThereIsNothingToGoOnFrom) {
  EXPECT_FALSE(find_interrupted(archive, scene));
}

TEST_F(Stopped, ACheckpointWithoutItsArchiveIsRefused) {
  write_checkpoint(checkpoint_path(archive), checkpoint);
  EXPECT_THROW(find_interrupted(archive, scene), CheckpointError);
  std::ofstream(unfinished_path(archive)) << "no archive";
  EXPECT_THROW(find_interrupted(archive, scene), CheckpointError);
}

TEST_F(Stopped, AnEndThatFailsLeavesWhatTheCheckpointGoesOnFrom) {
  std::filesystem::create_directories(archive / "in the way");
  EXPECT_THROW(run_to_the_end(archive, scene), ArchiveError);
  EXPECT_TRUE(std::filesystem::exists(unfinished_path(archive)));
  EXPECT_TRUE(find_interrupted(archive, scene));
  std::filesystem::remove_all(archive);
  run_to_the_end(archive, scene);
  const auto whole = folder.path() / "whole.h5";
  run_to_the_end(whole, scene);
  expect_same_archive(archive, whole);
}

/// As a writer that was killed while it wrote a chunk of /series/time anew leaves it: with another checksum.
void tear_the_times(const std::filesystem::path& archive) {
  const std::vector<double> times = ArchiveReader(archive).series({"time"}).values.at(0);
  ASSERT_GT(times.size(), 2u);
  const std::string known(reinterpret_cast<const char*>(times.data()), 3 * sizeof(double));
  std::fstream file(archive, std::ios::in | std::ios::out | std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(file), {});
  const auto chunk = bytes.find(known);
  ASSERT_NE(chunk, std::string::npos);
  constexpr std::size_t rows_per_chunk = 1024;
  file.seekp(static_cast<std::streamoff>(chunk + rows_per_chunk * sizeof(double)));
  file << "torn";
}

TEST_F(Stopped, ATornLastChunkStillHasWhatTheCheckpointGoesOnFrom) {
  ChildProcess child([&](const ChildProcess::Tell& tell) { run_to_the_end(archive, scene, tell); });
  for (int k = 0; k < 5; ++k) ASSERT_EQ(child.read_line(), "checkpoint");
  child.kill();
  tear_the_times(unfinished_path(archive));
  ASSERT_TRUE(find_interrupted(archive, scene));
  run_to_the_end(archive, scene);
  const auto whole = folder.path() / "whole.h5";
  run_to_the_end(whole, scene);
  expect_same_archive(archive, whole);
}

TEST_F(Stopped, ACheckpointOfAnotherCaseIsRefused) {
  run_to_the_end(archive, scene);
  write_checkpoint(checkpoint_path(archive), checkpoint);
  EXPECT_EQ(find_interrupted(archive, scene)->archive, archive);
  scene.inflow.velocity *= 2;
  EXPECT_THROW(find_interrupted(archive, scene), CheckpointError);
}

}  // namespace
}  // namespace rouleau::storage
