#include <system_error>

#include <SQLiteCpp/Statement.h>

#include "storage/archive_error.h"
#include "storage/backup.h"
#include "storage/durable_file.h"
#include "storage/manifest.h"
#include "storage/sha256.h"
#include "storage/sqlite/database.h"
#include "storage/sqlite/migrations.h"
#include "storage/store_error.h"

namespace rouleau::storage {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_shown = 20;

/// The folder in the making, gone unless it gets its name.
class Making {
 public:
  explicit Making(const fs::path& data) : path_(data) {
    path_ += ".restoring";
    fs::remove_all(path_);
    fs::create_directories(path_ / "archives");
  }
  ~Making() {
    std::error_code ignored;
    if (!named_) fs::remove_all(path_, ignored);
  }
  Making(const Making&) = delete;
  Making& operator=(const Making&) = delete;

  const fs::path& path() const { return path_; }
  void take_name(const fs::path& name) {
    publish(path_, name);
    named_ = true;
  }

 private:
  fs::path path_;
  bool named_ = false;
};

void refuse_what_is_there(const fs::path& data) {
  if (fs::exists(data) && (!fs::is_directory(data) || !fs::is_empty(data))) {
    throw StoreError(StoreError::Kind::invalid_argument,
                     data.string() + " is there and not empty: restore into a new folder");
  }
}

/// What is wrong with a file of the backup, or nothing.
std::string bring(const fs::path& backup, const ManifestFile& file, const fs::path& to) {
  const fs::path content = content_path(backup, file.sha256);
  std::error_code error;
  const auto size = fs::file_size(content, error);
  if (error) return "is not there";
  if (size != file.size) return "has " + std::to_string(size) + " bytes, not " + std::to_string(file.size);
  fs::create_directories(to.parent_path());
  storage::copy(content, to);
  if (sha256_hex_of_file(to) != file.sha256) return "is damaged";
  sync(to);
  return {};
}

/// What is wrong with the job store, or nothing.
std::string fault_of_database(const fs::path& file, const Manifest& manifest) {
  if (!fs::exists(file)) return "the backup has no job store";
  SQLite::Database database = open_for_reading(file);
  const std::string found = database.execAndGet("PRAGMA integrity_check").getString();
  if (found != "ok") return "the job store is damaged: " + found;
  const auto jobs = database.execAndGet("SELECT count(*) FROM jobs").getInt64();
  if (jobs != manifest.jobs) return "the job store has not the jobs that it had";
  return {};
}

[[noreturn]] void refuse(const fs::path& backup, const std::vector<std::string>& faults) {
  std::string text = backup.string() + " cannot be restored:";
  for (std::size_t k = 0; k < faults.size() && k < most_shown; ++k) text += "\n  " + faults[k];
  if (faults.size() > most_shown) text += "\n  and " + std::to_string(faults.size() - most_shown) + " more";
  throw ArchiveError(ArchiveError::Kind::format, text);
}

}  // namespace

RestoreReport restore(const fs::path& backup, const fs::path& data) {
  const Manifest manifest = read_manifest(backup);
  if (manifest.schema > migrations().back().number) {
    throw StoreError(StoreError::Kind::schema_too_new, backup.string() + " was made by a newer program (" +
                                                           manifest.engine + "): restore it with that");
  }
  try {
    const fs::path name = fs::absolute(data).lexically_normal();
    const fs::path target = name.has_filename() ? name : name.parent_path();
    refuse_what_is_there(target);
    Making making(target);
    RestoreReport report{manifest.jobs, 0, 0, manifest.missing};
    std::vector<std::string> faults;
    for (const ManifestFile& file : manifest.files) {
      const std::string fault = bring(backup, file, making.path() / file.path);
      if (!fault.empty()) faults.push_back(file.path + ' ' + fault);
      ++report.files;
      report.bytes += file.size;
    }
    if (faults.empty()) {
      const std::string fault = fault_of_database(making.path() / database_name, manifest);
      if (!fault.empty()) faults.push_back(fault);
    }
    if (!faults.empty()) refuse(backup, faults);
    for (const auto& entry : fs::recursive_directory_iterator(making.path())) {
      if (entry.is_directory()) sync(entry.path());
    }
    making.take_name(target);
    return report;
  } catch (const SQLite::Exception& error) {
    throw to_store_error(error);
  } catch (const fs::filesystem_error& error) {
    throw ArchiveError(ArchiveError::Kind::io, error.what());
  }
}

}  // namespace rouleau::storage
