#include "storage/sqlite/folder_lock.h"

#include <fstream>

#include <gtest/gtest.h>

#include "storage/job_store.h"
#include "tests/unit/storage/child_process.h"
#include "tests/unit/storage/scratch.h"

namespace rouleau::storage {
namespace {

TEST(FolderLock, ASecondProcessIsRefusedByNameAndPid) {
  const ScratchFolder folder;
  ChildProcess holder([&](const ChildProcess::Tell& tell) {
    const JobStore store(folder.path());
    tell("holding");
    pause();
  });
  ASSERT_EQ(holder.read_line(), "holding");
  try {
    const JobStore store(folder.path());
    FAIL() << "two at once";
  } catch (const StoreError& error) {
    EXPECT_EQ(error.kind(), StoreError::Kind::folder_in_use);
    const std::string text = error.what();
    EXPECT_NE(text.find(folder.path().string()), std::string::npos) << text;
    EXPECT_NE(text.find("process " + std::to_string(holder.pid())), std::string::npos) << text;
  }
  holder.kill();
  EXPECT_NO_THROW(JobStore(folder.path())) << "a dead process holds nothing";
}

TEST(FolderLock, ASecondStoreInOneProcessIsRefusedToo) {
  const ScratchFolder folder;
  const JobStore store(folder.path());
  EXPECT_THROW(JobStore(folder.path()), StoreError);
}

TEST(FolderLock, AFolderThatCannotBeMadeIsSaid) {
  const ScratchFolder folder;
  std::ofstream(folder.path() / "file") << "x";
  try {
    const JobStore store(folder.path() / "file" / "data");
    FAIL();
  } catch (const StoreError& error) {
    EXPECT_EQ(error.kind(), StoreError::Kind::io);
    EXPECT_NE(std::string(error.what()).find("data"), std::string::npos);
  }
}

TEST(FolderLock, ADatabaseThatIsNoneIsSaid) {
  const ScratchFolder folder;
  std::ofstream(folder.path() / "jobs.sqlite") << std::string(8192, 'x');
  try {
    const JobStore store(folder.path());
    FAIL();
  } catch (const StoreError& error) {
    EXPECT_EQ(error.kind(), StoreError::Kind::corrupt);
  }
}

}  // namespace
}  // namespace rouleau::storage
