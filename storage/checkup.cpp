#include "storage/checkup.h"

#include <algorithm>

#include <SQLiteCpp/Statement.h>

#include "storage/archive_error.h"
#include "storage/checkup_parts.h"
#include "storage/durable_file.h"
#include "storage/manifest.h"
#include "storage/sqlite/database.h"
#include "storage/sqlite/folder_lock.h"
#include "storage/sqlite/migrations.h"
#include "storage/store_error.h"

namespace rouleau::storage {

namespace {

namespace fs = std::filesystem;
using Kind = Finding::Kind;

constexpr std::uint64_t little_room = std::uint64_t{1} << 30;

/// Whether the rest of the checkup can read the store.
bool examine_database(Examination& examination) {
  const std::string name(database_name);
  const std::string from_backup =
      "restore a backup (rouleau restore), or recover what there is (sqlite3 .recover)";
  SQLite::Statement check(examination.database, "PRAGMA integrity_check(5)");
  while (check.executeStep()) {
    const std::string found = check.getColumn(0).getString();
    if (found != "ok") examination.add(Kind::damage, name, found, from_backup);
  }
  SQLite::Statement keys(examination.database, "PRAGMA foreign_key_check");
  while (keys.executeStep()) {
    examination.add(Kind::damage, name, "a row of " + keys.getColumn(0).getString() + " has lost its job",
                    from_backup);
  }
  if (!examination.result.healthy()) return false;

  const int schema = examination.database.execAndGet("PRAGMA user_version").getInt();
  const int known = migrations().back().number;
  if (schema == known) return true;
  if (schema > known) {
    examination.add(Kind::damage, name, "was written by a newer program", "use that program");
  } else {
    examination.add(
        Kind::note, name,
        "is of an earlier release; start the service once, which brings it up to date, and check again");
  }
  return false;
}

void count_jobs(Examination& examination) {
  examination.result.jobs = examination.database.execAndGet("SELECT count(*) FROM jobs").getInt64();
  SQLite::Statement held(examination.database, "SELECT count(*) FROM jobs WHERE lease_owner IS NOT NULL");
  held.executeStep();
  if (const int count = held.getColumn(0).getInt(); count > 0) {
    examination.add(Kind::note, std::string(database_name),
                    std::to_string(count) +
                        " jobs were running when the service ended; the next start goes on with them");
  }
  SQLite::Statement paused(examination.database,
                           "SELECT 1 FROM settings WHERE name = 'queue' AND value = 'paused'");
  if (paused.executeStep()) {
    examination.add(Kind::note, std::string(database_name),
                    "the queue is paused: no job starts until it is resumed (POST /v1/queue:resume)");
  }
}

void examine_room(Examination& examination) {
  const fs::space_info space = fs::space(examination.data);
  examination.result.free_bytes = space.available;
  if (space.available < little_room) {
    examination.add(Kind::note, ".",
                    "the disk has only " + std::to_string(space.available >> 20) + " MiB left");
  }
}

}  // namespace

std::string_view to_string(Finding::Kind kind) {
  switch (kind) {
    case Kind::note:
      return "note";
    case Kind::leftover:
      return "leftover";
    case Kind::lost:
      return "lost";
    case Kind::damage:
      return "damage";
  }
  return "damage";
}

bool Checkup::healthy() const {
  return std::all_of(findings.begin(), findings.end(),
                     [](const Finding& finding) { return finding.kind == Kind::note || finding.mended; });
}

Finding& Examination::add(Finding::Kind kind, std::string subject, std::string message, std::string mend) {
  result.findings.push_back({kind, std::move(subject), std::move(message), std::move(mend)});
  return result.findings.back();
}

void Examination::put_away(Finding& finding, const fs::path& file) const {
  const fs::path to = data / "lost+found" / file.lexically_relative(data);
  fs::path free = to;
  for (int k = 2; fs::exists(free); ++k) free = to.string() + '.' + std::to_string(k);
  fs::create_directories(free.parent_path());
  publish(file, free);
  finding.mended = true;
}

Checkup check_up(const fs::path& data, const CheckupOptions& options) {
  if (!fs::exists(data / database_name)) {
    throw StoreError(StoreError::Kind::io, data.string() + " is no data folder: it has no job store");
  }
  const FolderLock lock(data);
  Checkup result;
  try {
    SQLite::Database database =
        options.mend ? open_for_writing(data / database_name) : open_for_reading(data / database_name);
    Examination examination{data, options, database, result};
    examine_room(examination);
    if (!examine_database(examination)) return result;
    count_jobs(examination);
    examine_archives(examination);
    examine_files(examination);
  } catch (const SQLite::Exception& error) {
    const StoreError known = to_store_error(error);
    if (known.kind() != StoreError::Kind::corrupt) throw known;
    result.findings.push_back(
        {Kind::damage, std::string(database_name), error.what(), "restore a backup (rouleau restore)"});
  } catch (const fs::filesystem_error& error) {
    throw StoreError(StoreError::Kind::io, error.what());
  }
  return result;
}

}  // namespace rouleau::storage
