#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include <SQLiteCpp/Database.h>

#include "storage/checkup.h"

namespace rouleau::storage {

/// What the parts of a checkup share.
struct Examination {
  const std::filesystem::path& data;
  const CheckupOptions& options;
  SQLite::Database& database;
  Checkup& result;

  Finding& add(Finding::Kind kind, std::string subject, std::string message, std::string mend = {});
  /// Moves a file of the folder into its lost+found, where the name that it had is kept.
  void put_away(Finding& finding, const std::filesystem::path& file) const;
};

/// Each archive that a job has is there, whole, and what the job says.
void examine_archives(Examination& examination);

/// Each file of the folder belongs to something.
void examine_files(Examination& examination);

}  // namespace rouleau::storage
