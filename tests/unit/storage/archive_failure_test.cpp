#include <fstream>
#include <random>
#include <sstream>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "storage/archive.h"
#include "tests/unit/storage/child_process.h"
#include "tests/unit/storage/scratch.h"
#include "tests/unit/storage/small_disk.h"
#include "tests/unit/storage/synthetic_run.h"

namespace rouleau::storage {
namespace {

std::string content_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::stringstream content;
  content << stream.rdbuf();
  return content.str();
}

/// Reads everything there is; false if the archive was refused somewhere.
bool reads_all(const std::filesystem::path& path) {
  try {
    const ArchiveReader reader(path);
    reader.series();
    reader.case_given();
    reader.case_resolved();
    reader.plan();
    reader.summary();
    reader.version();
    const int frames = reader.frame_count();
    for (int k = 0; k < frames; ++k) {
      reader.frame(k);
      reader.outlines(k);
    }
    return true;
  } catch (const ArchiveError&) {
    return false;
  }
}

void write_archive(const std::filesystem::path& path, int frames) {
  ArchiveWriter writer(path, synthetic_case_given);
  deliver(writer, frames);
  writer.finish(SyntheticRun::summary());
}

TEST(ArchiveFailure, AKilledWriterLeavesNoFinalFile) {
  const ScratchFolder folder;
  const auto path = folder.path() / "run.h5";
  {
    ChildProcess child([&](const ChildProcess::Tell& tell) {
      ArchiveWriter writer(path, "{}");
      deliver(writer, 3);
      tell("writing");
      for (int k = 3;; ++k) writer.frame(SyntheticRun::frame(k));
    });
    ASSERT_EQ(child.read_line(), "writing");
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    child.kill();
  }
  EXPECT_FALSE(std::filesystem::exists(path));
  write_archive(path, 2);
  EXPECT_EQ(ArchiveReader(path).frame_count(), 2) << "what was left aside is no obstacle";
  EXPECT_FALSE(std::filesystem::exists(unfinished_path(path)));
}

/// Writes frames until the disk is full, and tells what came of it.
std::string fill_with_frames(const std::filesystem::path& path) {
  const auto name_of = [](ArchiveError::Kind kind) {
    return kind == ArchiveError::Kind::disk_full ? "full" : "another error";
  };
  try {
    ArchiveWriter writer(path, "{}");
    writer.begin(SyntheticRun::header());
    for (int k = 0; k < 20'000; ++k) writer.frame(SyntheticRun::frame(k));
    return "never full";
  } catch (const ArchiveError& error) {
    const bool clean = !std::filesystem::exists(unfinished_path(path)) && !std::filesystem::exists(path);
    return clean ? name_of(error.kind()) : "left something behind";
  }
}

TEST(ArchiveFailure, AFileSizeLimitIsATypedErrorAndTheProcessGoesOn) {
  const ScratchFolder folder;
  ChildProcess child([&](const ChildProcess::Tell& tell) {
    signal(SIGXFSZ, SIG_IGN);
    limit_file_size(200'000);
    tell(fill_with_frames(folder.path() / "run.h5"));
    limit_file_size(RLIM_INFINITY);
    write_archive(folder.path() / "next.h5", 3);
    tell(std::to_string(ArchiveReader(folder.path() / "next.h5").frame_count()));
  });
  EXPECT_EQ(child.read_line(), "full");
  EXPECT_EQ(child.read_line(), "3");
  EXPECT_EQ(child.wait(), 0);
}

TEST(ArchiveFailure, ASmallFileSystemIsATypedErrorAndTheProcessGoesOn) {
  const ScratchFolder folder;
  ChildProcess child([&](const ChildProcess::Tell& tell) {
    if (!mount_small_disk(folder.path())) {  // the test above covers what is left
      tell("full");
      return tell("3");
    }
    tell(fill_with_frames(folder.path() / "run.h5"));
    write_archive(folder.path() / "next.h5", 3);
    tell(std::to_string(ArchiveReader(folder.path() / "next.h5").frame_count()));
    std::exit(0);  // through HDF5's own clean-up, which stumbles over files that it could not close
  });
  EXPECT_EQ(child.read_line(), "full");
  EXPECT_EQ(child.read_line(), "3");
  EXPECT_EQ(child.wait(), 0);
}

TEST(ArchiveFailure, ATruncatedArchiveIsRefused) {
  const ScratchFolder folder;
  const auto path = folder.path() / "run.h5";
  write_archive(path, 4);
  const std::string whole = content_of(path);
  ASSERT_TRUE(reads_all(path));
  const auto cut = folder.path() / "cut.h5";
  for (std::size_t part = 0; part < 40; ++part) {
    std::ofstream(cut, std::ios::binary | std::ios::trunc) << whole.substr(0, whole.size() * part / 40);
    EXPECT_FALSE(reads_all(cut)) << part << "/40 of the archive";
  }
}

TEST(ArchiveFailure, ADamagedArchiveIsRefusedOrReadButNeverACrash) {
  const ScratchFolder folder;
  const auto path = folder.path() / "run.h5";
  write_archive(path, 4);
  const std::string whole = content_of(path);
  const auto damaged = folder.path() / "damaged.h5";
  ChildProcess child([&](const ChildProcess::Tell& tell) {
    std::mt19937 random(7);
    int refused = 0;
    for (int i = 0; i < 150; ++i) {
      std::string bytes = whole;
      bytes[random() % bytes.size()] ^= static_cast<char>(1 + random() % 255);
      std::ofstream(damaged, std::ios::binary | std::ios::trunc) << bytes;
      refused += reads_all(damaged) ? 0 : 1;
    }
    tell(std::to_string(refused));
  });
  const int refused = std::atoi(child.read_line().c_str());
  EXPECT_EQ(child.wait(), 0) << "the reader crashed";
  EXPECT_GT(refused, 10) << "the damage was not noticed";
}

TEST(ArchiveFailure, WhatIsNoArchiveIsRefused) {
  const ScratchFolder folder;
  for (const std::string& content : {std::string(), std::string("x"), std::string(100'000, '\0'),
                                     std::string("\x89HDF\r\n\x1a\n") + std::string(5000, '\xff')}) {
    const auto path = folder.path() / "x.h5";
    std::ofstream(path, std::ios::binary | std::ios::trunc) << content;
    EXPECT_FALSE(reads_all(path));
  }
  EXPECT_FALSE(reads_all(folder.path()));
}

}  // namespace
}  // namespace rouleau::storage
