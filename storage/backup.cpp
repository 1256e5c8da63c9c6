#include "storage/backup.h"

#include <cerrno>
#include <fcntl.h>
#include <optional>
#include <set>
#include <sqlite3.h>
#include <system_error>
#include <unistd.h>

#include <SQLiteCpp/Backup.h>
#include <SQLiteCpp/Statement.h>

#include "engine/simulation/run.h"
#include "storage/archive_error.h"
#include "storage/archive_writer.h"
#include "storage/durable_file.h"
#include "storage/job_store.h"
#include "storage/manifest.h"
#include "storage/sha256.h"
#include "storage/sqlite/database.h"
#include "storage/sqlite/folder_lock.h"
#include "storage/sqlite/migrations.h"

namespace rouleau::storage {

namespace {

namespace fs = std::filesystem;

constexpr const char* aside_name = "next.part";

struct Archive {
  std::string id;
  std::uint64_t size = 0;
  std::string sha256;
};

/// The store at one instant as a file of its own, of this program's schema and without a log beside it.
void copy_database(const fs::path& from, const fs::path& to) {
  fs::remove(to);
  SQLite::Database source = open_for_reading(from);
  SQLite::Database copy(to.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  if (SQLite::Backup(copy, source).executeStep() != SQLITE_DONE) {
    throw StoreError(StoreError::Kind::busy, from.string() + " is locked by another program; try again");
  }
  // Pages are copied as they are, also damaged ones.
  if (const std::string state = copy.execAndGet("PRAGMA integrity_check").getString(); state != "ok") {
    throw StoreError(StoreError::Kind::corrupt, from.string() + " is damaged (" + state +
                                                    "); the backup stays as it was, see rouleau doctor");
  }
  copy.exec("PRAGMA journal_mode = DELETE");
  migrate(copy);
}

std::vector<Archive> archives_of(SQLite::Database& database) {
  std::vector<Archive> archives;
  SQLite::Statement select(database,
                           "SELECT archive_id, archive_size, archive_sha256 FROM jobs "
                           "WHERE archive_id IS NOT NULL GROUP BY archive_id");
  while (select.executeStep()) {
    archives.push_back({select.getColumn(0).getString(),
                        static_cast<std::uint64_t>(select.getColumn(1).getInt64()),
                        select.getColumn(2).getString()});
  }
  return archives;
}

/// A SHA-256 in hexadecimal digits.
bool is_content_name(std::string_view name) {
  return name.size() == 64 && name.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

/// That a folder is empty or a backup, finished or not: a backup of it must not take away what else is there.
void check_target(const fs::path& backup) {
  if (fs::exists(manifest_path(backup))) {
    read_manifest(backup);
    return;
  }
  const std::set<std::string> ours{"files", "lock", aside_name,
                                   manifest_path(backup).filename().string() + ".part"};
  for (const auto& entry : fs::directory_iterator(backup)) {
    if (ours.contains(entry.path().filename())) continue;
    throw ArchiveError(ArchiveError::Kind::misuse, backup.string() + " holds " +
                                                       entry.path().filename().string() +
                                                       " and no backup; name a folder for the backup alone");
  }
  if (!fs::is_directory(backup / "files")) return;
  for (const auto& entry : fs::directory_iterator(backup / "files")) {
    if (is_content_name(entry.path().filename().string())) continue;
    throw ArchiveError(ArchiveError::Kind::misuse,
                       (backup / "files").string() + " holds " + entry.path().filename().string() +
                           ", which no backup has; name a folder for the backup alone");
  }
}

/// Puts contents into a backup under their own names.
class Collection {
 public:
  Collection(fs::path backup, bool links) : backup_(std::move(backup)), links_(links) {
    fs::create_directories(backup_ / "files");
  }

  /// A file whose content is known; false if it is gone or not what it should be.
  bool add_known(const std::string& path, const fs::path& source, const Archive& known) {
    const fs::path content = content_path(backup_, known.sha256);
    std::error_code error;
    if (const auto size = fs::file_size(content, error); error || size != known.size) {
      if (!bring(source, content, known)) return false;
      count_added(known.size);
    }
    note({path, known.size, known.sha256});
    return true;
  }

  /// A file whose content may change meanwhile: what it has now.
  void add(const std::string& path, const fs::path& source) {
    std::error_code gone;
    if (!fs::exists(source, gone)) return;
    storage::copy(source, aside());
    take_in(path);
  }

  /// The file at `aside()` itself.
  void take_in(const std::string& path) {
    const ManifestFile file{path, fs::file_size(aside()), sha256_hex_of_file(aside())};
    const fs::path content = content_path(backup_, file.sha256);
    if (!fs::exists(content)) count_added(file.size);
    fs::rename(aside(), content);
    note(file);
  }

  fs::path aside() const { return backup_ / aside_name; }
  const std::vector<ManifestFile>& files() const { return files_; }
  const BackupReport& report() const { return report_; }

  /// Once another manifest is there, contents of the one before are not needed.
  void prune() const {
    std::set<std::string> needed;
    for (const ManifestFile& file : files_) needed.insert(file.sha256);
    for (const auto& entry : fs::directory_iterator(backup_ / "files")) {
      const std::string name = entry.path().filename();
      if (is_content_name(name) && !needed.contains(name)) fs::remove(entry.path());
    }
  }

 private:
  bool bring(const fs::path& source, const fs::path& content, const Archive& known) {
    std::error_code gone;
    if (fs::file_size(source, gone) != known.size || gone) return false;
    if (links_) {
      if (sha256_hex_of_file(source) != known.sha256) return false;
      if (::link(source.c_str(), content.c_str()) == 0) return true;
    }
    storage::copy(source, aside());
    if (sha256_hex_of_file(aside()) != known.sha256) return false;
    fs::rename(aside(), content);
    return true;
  }

  void count_added(std::uint64_t size) {
    ++report_.added;
    report_.added_bytes += size;
  }

  void note(const ManifestFile& file) {
    files_.push_back(file);
    ++report_.files;
    report_.bytes += file.size;
  }

  const fs::path backup_;
  const bool links_;
  std::vector<ManifestFile> files_;
  BackupReport report_;
};

/// All that was written to the file system of this folder is on the disk when this returns.
void sync_file_system(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_CLOEXEC);
  const bool done = descriptor >= 0 && ::syncfs(descriptor) == 0;
  const int error = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (!done) {
    throw ArchiveError(ArchiveError::Kind::io,
                       folder.string() + ": " + std::generic_category().message(error));
  }
}

void add_folder(Collection& collection, const fs::path& data, const std::string& folder) {
  if (!fs::is_directory(data / folder)) return;
  for (const auto& entry : fs::directory_iterator(data / folder)) {
    if (entry.is_regular_file()) {
      collection.add(folder + '/' + entry.path().filename().string(), entry.path());
    }
  }
}

/// @return archives that jobs have and that are gone or damaged
std::vector<std::string> add_archives(Collection& collection, const fs::path& data,
                                      const std::vector<Archive>& archives) {
  std::vector<std::string> missing;
  for (const Archive& archive : archives) {
    const std::string name = "archives/" + archive.id + ".h5";
    if (!collection.add_known(name, data / name, archive)) {
      missing.push_back(name);
      continue;
    }
    collection.add(sidecar_path(name).string(), sidecar_path(data / name));
  }
  return missing;
}

bool has_jobs_with(const fs::path& data, const std::vector<std::string>& archives) {
  SQLite::Database database = open_for_reading(data / database_name);
  for (const std::string& name : archives) {
    SQLite::Statement select(database, "SELECT 1 FROM jobs WHERE archive_id = ?");
    select.bind(1, fs::path(name).stem().string());
    if (select.executeStep()) return true;
  }
  return false;
}

/// One try: the store, then what its jobs have. A job may be removed in between.
Manifest collect(Collection& collection, const fs::path& data) {
  Manifest manifest;
  manifest.created_at = system_clock_ms();
  manifest.engine = engine_version();
  copy_database(data / database_name, collection.aside());
  std::vector<Archive> archives;
  {
    SQLite::Database copy = open_for_reading(collection.aside());
    manifest.schema = copy.execAndGet("PRAGMA user_version").getInt();
    manifest.jobs = copy.execAndGet("SELECT count(*) FROM jobs").getInt64();
    archives = archives_of(copy);
  }
  collection.take_in(std::string(database_name));
  manifest.missing = add_archives(collection, data, archives);
  add_folder(collection, data, "logs");
  manifest.files = collection.files();
  return manifest;
}

}  // namespace

BackupReport back_up(const fs::path& data, const fs::path& backup, bool links) {
  if (!fs::exists(data / database_name)) {
    throw StoreError(StoreError::Kind::io, data.string() + " is no data folder: it has no job store");
  }
  try {
    fs::create_directories(backup);
    check_target(backup);
    const FolderLock lock(backup);
    std::optional<Collection> collection(std::in_place, backup, links);
    Manifest manifest = collect(*collection, data);
    if (!manifest.missing.empty() && has_jobs_with(data, manifest.missing) == false) {
      collection.emplace(backup, links);
      manifest = collect(*collection, data);
    }
    sync_file_system(backup);
    write_manifest(backup, manifest);
    collection->prune();
    BackupReport report = collection->report();
    report.jobs = manifest.jobs;
    report.missing = manifest.missing;
    return report;
  } catch (const SQLite::Exception& error) {
    throw to_store_error(error);
  } catch (const fs::filesystem_error& error) {
    throw ArchiveError(ArchiveError::Kind::io, error.what());
  }
}

}  // namespace rouleau::storage
