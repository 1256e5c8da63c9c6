#pragma once

#include <atomic>
#include <filesystem>
#include <string>

#include "storage/job_store.h"
#include "storage/sha256.h"

namespace rouleau::storage {

/// A folder of the test's own, gone with it.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "rouleau-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("mkdtemp failed");
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A clock that stands until it is moved.
struct BentClock {
  std::atomic<TimeMs> now = 1'800'000'000'000;

  Clock clock() {
    return [this] { return now.load(); };
  }
};

/// No two of them have the same case.
inline NewJob plain_job(const std::string& name = "plain", int priority = 0) {
  static std::atomic<int> count = 0;
  NewJob job;
  job.name = name;
  job.case_hash = sha256_hex(std::to_string(++count));
  job.case_given = R"({"version":1})";
  job.case_resolved = R"({"version":1,"name":")" + name + "\"}";
  job.plan = R"({"particles":10})";
  job.priority = priority;
  return job;
}

inline const JobResult some_result{R"({"ending":"completed"})", 1234, std::string(64, 'a')};

}  // namespace rouleau::storage
