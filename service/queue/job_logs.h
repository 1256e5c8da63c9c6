#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <string>
#include <string_view>

#include "service/log.h"
#include "storage/job.h"

namespace rouleau::service {

/// The log of each job: a file of its own, one line an event of its life, `TIME event=... key=value`. A log
/// that cannot be written is the server's trouble, not the job's: it says so in its own log and goes on.
/// Safe to call from any thread.
class JobLogs {
 public:
  /// Nothing more is written to a log of this size, in bytes.
  static constexpr std::uint64_t largest = 1 << 20;
  /// From here on only what changes the job's state is, so that its end is in its log.
  static constexpr std::uint64_t routine_until = largest / 2;

  /// @param folder  made if it is not there
  explicit JobLogs(std::filesystem::path folder);

  /// A change of the job's state, or what somebody asked for.
  void note(const storage::Job& job, std::string_view event, log::Fields fields = {});
  /// What comes again and again.
  void note_routine(const storage::Job& job, std::string_view event, log::Fields fields = {});
  /// The same as `note` for an end: a log that is gone is not begun anew, for its job was removed.
  void note_end(const storage::Job& job, std::string_view event, log::Fields fields = {});

  /// From a byte on to its end. A job that nothing has happened to was accepted, at least.
  std::string read(const storage::Job& job, std::uint64_t from) const;

  void remove(std::string_view id);

 private:
  std::filesystem::path path(std::string_view id) const;
  void append(const storage::Job& job, const std::string& line, std::uint64_t limit, bool begin);

  const std::filesystem::path folder_;
  std::mutex mutex_;
};

}  // namespace rouleau::service
