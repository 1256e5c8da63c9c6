#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "service/archive_use.h"
#include "storage/job_store.h"

namespace rouleau::service {

/// What is kept of jobs that have ended; without limits all of it.
struct RetentionRules {
  std::optional<std::chrono::duration<double>> keep{};  ///< after a job's end
  std::optional<std::uint64_t> most_archive_bytes{};
  std::uint64_t least_free_bytes = 0;  ///< on the disk of the data folder
  std::chrono::duration<double> interval = std::chrono::minutes(1);
};

/// Removes jobs that have ended, the oldest first: those beyond their age, and as many as it takes to keep
/// within the room. A job of a sweep that still runs stays, and so does one whose archive is being read.
/// Where that leaves no room, no job is let in.
class Retention {
 public:
  /// Removes the files of a job that the store has forgotten.
  using Forget = std::function<void(const std::string& id, const std::optional<std::string>& archive_id)>;

  Retention(storage::JobStore& store, ArchiveUse use, std::filesystem::path data, RetentionRules rules,
            Forget forget, storage::Clock clock = storage::system_clock_ms);
  ~Retention();
  Retention(const Retention&) = delete;
  Retention& operator=(const Retention&) = delete;

  /// From now on it looks after the folder by itself, on a thread of its own.
  void start();

  /// Looks once.
  void run();

  /// @throws Problem 503 no-space
  void check_room();

 private:
  void keep_running();
  int remove_the_old();
  int make_room();
  using Choice = std::function<bool(const storage::EndedJob&)>;
  /// From the oldest on, until one is not to go; what must stay, or is not worth removing, is passed over.
  /// @return how many were removed
  int remove_while(
      const Choice& is_to_go, const Choice& is_worth_it = [](const storage::EndedJob&) { return true; });
  /// A hard link, such as that of a backup, keeps its bytes on the disk.
  bool frees_room(const storage::EndedJob& job) const;
  bool remove(const std::string& id);
  /// What is wrong with the room, or nothing.
  std::string lack_of_room() const;
  std::string lack_of_disk() const;
  std::string lack_of_allowance() const;

  storage::JobStore& store_;
  const ArchiveUse use_;
  const std::filesystem::path data_;
  const RetentionRules rules_;
  const Forget forget_;
  const storage::Clock clock_;

  std::mutex mutex_;
  std::condition_variable stopped_;
  bool stopping_ = false;
  std::atomic<bool> archives_full_ = false;  ///< as the last look found them
  std::thread thread_;
};

}  // namespace rouleau::service
