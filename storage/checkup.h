#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace rouleau::storage {

/// Something in a data folder that a person should know of.
struct Finding {
  enum class Kind {
    note,      ///< nothing is wrong with it
    leftover,  ///< a file that nothing needs; mended by putting it into lost+found
    lost,      ///< what a job should have and has not; mended by saying so in the job, which may be retried
    damage,    ///< only a person can mend it
  };
  Kind kind = Kind::note;
  std::string subject;  ///< a file in the folder, or the id of a job
  std::string message;
  std::string mend;  ///< what would mend it
  bool mended = false;
};

std::string_view to_string(Finding::Kind kind);

struct CheckupOptions {
  bool deep = false;  ///< compare the SHA-256 of every archive
  bool mend = false;
};

struct Checkup {
  std::int64_t jobs = 0;
  std::int64_t archives = 0;
  std::uint64_t archive_bytes = 0;
  std::uint64_t free_bytes = 0;  ///< left on the disk
  std::vector<Finding> findings;

  /// Nothing is left to be mended.
  bool healthy() const;
};

/// Compares what the store of a data folder says with what is on the disk. No service may use the folder
/// meanwhile. Mending deletes nothing.
/// @throws StoreError if the folder is in use, or none
Checkup check_up(const std::filesystem::path& data, const CheckupOptions& options);

}  // namespace rouleau::storage
