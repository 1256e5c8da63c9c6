#include "storage/checkpoint_file.h"

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "engine/error/checkpoint_error.h"
#include "storage/archive_error.h"
#include "tests/unit/storage/scratch.h"

namespace rouleau::storage {
namespace {

class CheckpointFile : public testing::Test {
 protected:
  CheckpointFile() {
    for (int k = 0; k < 1000; ++k) checkpoint.bytes.push_back(static_cast<std::byte>(k * k));
    write_checkpoint(path, checkpoint);
  }

  std::string content() const {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
  }
  void replace(const std::string& text) const {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
  }

  ScratchFolder folder;
  std::filesystem::path path = checkpoint_path(folder.path() / "out.h5");
  Checkpoint checkpoint;
};

TEST_F(CheckpointFile, GivesBackTheBytes) {
  EXPECT_EQ(path.filename(), "out.h5.checkpoint");
  EXPECT_EQ(read_checkpoint(path).bytes, checkpoint.bytes);
  checkpoint.bytes.clear();
  write_checkpoint(path, checkpoint);
  EXPECT_TRUE(read_checkpoint(path).bytes.empty());
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST_F(CheckpointFile, CutOffAnywhereIsRefused) {
  const std::string whole = content();
  for (std::size_t kept = 0; kept < whole.size(); kept += 7) {
    replace(whole.substr(0, kept));
    EXPECT_THROW(read_checkpoint(path), CheckpointError) << kept;
  }
}

TEST_F(CheckpointFile, AChangeOfAnyByteIsRefused) {
  const std::string whole = content();
  for (std::size_t at = 0; at < whole.size(); at += 3) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 4);
    replace(changed);
    EXPECT_THROW(read_checkpoint(path), CheckpointError) << at;
  }
}

TEST_F(CheckpointFile, WhatCannotBeWrittenOrReadIsSaidToBeSo) {
  EXPECT_THROW(read_checkpoint(folder.path() / "none"), ArchiveError);
  EXPECT_THROW(write_checkpoint(folder.path() / "no" / "folder", checkpoint), ArchiveError);
}

}  // namespace
}  // namespace rouleau::storage
