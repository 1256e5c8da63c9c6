#include <fstream>

#include <gtest/gtest.h>

#include "storage/job_store.h"
#include "tests/unit/storage/child_process.h"
#include "tests/unit/storage/scratch.h"
#include "tests/unit/storage/small_disk.h"

namespace rouleau::storage {
namespace {

constexpr int enough_to_fill_the_disk = 2000;

NewJob large_job() {
  NewJob job = plain_job();
  job.case_given = "\"" + std::string(20'000, 'x') + "\"";
  return job;
}

/// Submits until the store says what is expected of a full disk, makes room, and tells whether the store then
/// goes on and holds what it had accepted.
std::string fill_and_go_on(const std::filesystem::path& folder, StoreError::Kind expected,
                           const std::function<void()>& fill, const std::function<void()>& make_room) {
  JobStore store(folder);
  std::vector<std::string> accepted{store.submit(plain_job()).job.id};
  fill();
  try {
    for (int i = 0; i < enough_to_fill_the_disk; ++i) accepted.push_back(store.submit(large_job()).job.id);
    return "never full";
  } catch (const StoreError& error) {
    if (error.kind() != expected) return std::string("wrong kind: ") + error.what();
  }
  if (!store.find(accepted.front())) return "no reading while full";
  make_room();
  accepted.push_back(store.submit(plain_job()).job.id);
  for (const std::string& id : accepted) {
    if (!store.find(id)) return "lost " + id;
  }
  if (store.list({.page_size = 1000}).jobs.size() != accepted.size()) return "stored what it had refused";
  return "went on";
}

TEST(FullDisk, AFileSizeLimitIsATypedErrorAndTheStoreGoesOn) {
  const ScratchFolder folder;
  ChildProcess child([&](const ChildProcess::Tell& tell) {
    signal(SIGXFSZ, SIG_IGN);
    tell(fill_and_go_on(
        folder.path(), StoreError::Kind::io, [] { limit_file_size(300'000); },
        [] { limit_file_size(RLIM_INFINITY); }));
  });
  EXPECT_EQ(child.read_line(), "went on");
}

TEST(FullDisk, ASmallFileSystemIsATypedErrorAndTheStoreGoesOn) {
  const ScratchFolder folder;
  ChildProcess child([&](const ChildProcess::Tell& tell) {
    if (!mount_small_disk(folder.path())) return tell("went on");  // the test above covers what is left
    const auto ballast = folder.path() / "ballast";
    tell(fill_and_go_on(
        folder.path(), StoreError::Kind::disk_full,
        [&] { std::ofstream(ballast) << std::string(400'000, 'x'); },
        [&] { std::filesystem::remove(ballast); }));
  });
  EXPECT_EQ(child.read_line(), "went on");
}

}  // namespace
}  // namespace rouleau::storage
