#include "service/queue/job_files.h"

#include <fstream>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/storage/scratch.h"

namespace rouleau::service {
namespace {

class JobFiles : public testing::Test {
 protected:
  void make(const std::string& name) { std::ofstream(folder_.path() / name) << "x"; }
  std::set<std::string> names() const {
    std::set<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
      found.insert(entry.path().filename());
    }
    return found;
  }

  storage::ScratchFolder folder_;
};

TEST_F(JobFiles, OfDeadAttemptsAreRemovedUnlessTheirJobsGoOn) {
  const std::set<std::string> kept{"ended.h5", "ended.xdmf", "waits.h5.checkpoint", "waits.h5.part",
                                   "waits.h5.before"};
  for (const std::string& name : kept) make(name);
  for (const char* const name :
       {"ended.h5.part", "ended.h5.checkpoint", "ended.xdmf.part", "waits.h5.checkpoint.part",
        "waits.xdmf.part", "waits.h5.ending.part", "without_checkpoint.h5.part", "odd.part"}) {
    make(name);
  }
  tidy(folder_.path(), [](std::string_view id) { return id == "waits" || id == "without_checkpoint"; });
  EXPECT_EQ(names(), kept);
}

TEST_F(JobFiles, OfOneJobAreRemoved) {
  for (const char* const name : {"a.h5", "a.xdmf", "a.h5.part", "a.h5.before", "a.h5.checkpoint", "b.h5"})
    make(name);
  remove_unfinished(folder_.path(), "a");
  EXPECT_EQ(names(), (std::set<std::string>{"a.h5", "a.xdmf", "b.h5"}));
  remove_archive(folder_.path(), "a");
  EXPECT_EQ(names(), (std::set<std::string>{"b.h5"}));
  remove_archive(folder_.path(), "a");
}

TEST_F(JobFiles, AnUnfinishedArchiveIsReadWhereAnotherIsMadeFromIt) {
  EXPECT_TRUE(unfinished_archive(folder_.path(), "a").empty());
  make("a.h5.part");
  EXPECT_EQ(unfinished_archive(folder_.path(), "a"), folder_.path() / "a.h5.part");
  make("a.h5.before");
  EXPECT_EQ(unfinished_archive(folder_.path(), "a"), folder_.path() / "a.h5.before");
}

}  // namespace
}  // namespace rouleau::service
