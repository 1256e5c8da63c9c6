#include <map>
#include <set>
#include <string_view>

#include <SQLiteCpp/Statement.h>

#include "storage/checkup_parts.h"
#include "storage/uuid.h"

namespace rouleau::storage {

namespace {

namespace fs = std::filesystem;
using Kind = Finding::Kind;

using Ids = std::set<std::string>;

Ids ids_of(SQLite::Database& database, const std::string& select) {
  Ids ids;
  SQLite::Statement statement(database, select);
  while (statement.executeStep()) ids.insert(statement.getColumn(0).getString());
  return ids;
}

/// What jobs have on the disk.
struct Owners {
  explicit Owners(SQLite::Database& database)
      : jobs(ids_of(database, "SELECT id FROM jobs")),
        going_on(ids_of(
            database,
            "SELECT id FROM jobs WHERE ended_at IS NULL OR (state = 'failed' AND archive_id IS NULL)")),
        archives(ids_of(database, "SELECT DISTINCT archive_id FROM jobs WHERE archive_id IS NOT NULL")) {}

  Ids jobs;
  Ids going_on;  ///< or may, if they are tried again
  Ids archives;
};

/// Why nothing needs a file, or nothing.
std::string fault_of_archive_file(const Owners& owners, const std::string& id, std::string_view suffix) {
  if (suffix == ".h5" || suffix == ".xdmf") {
    // One of a job that goes on was finished just before the end of the service: its next attempt has only to
    // say so.
    return owners.archives.contains(id) || owners.going_on.contains(id) ? "" : "is of no job";
  }
  if (suffix == ".h5.part" || suffix == ".h5.before" || suffix == ".h5.checkpoint") {
    return owners.going_on.contains(id) ? "" : "was left unfinished, and its job does not go on";
  }
  return "was left half written";
}

/// @param fault_of  of a file's id and what follows it in its name
template <class FaultOf>
void examine_folder(Examination& examination, const std::string& folder, FaultOf fault_of) {
  const fs::path path = examination.data / folder;
  if (!fs::is_directory(path)) return;
  std::map<std::string, std::string> faults;
  for (const auto& entry : fs::directory_iterator(path)) {
    const std::string name = entry.path().filename().string();
    const std::string id = name.substr(0, name.find('.'));
    const std::string fault =
        is_uuid(id) ? fault_of(id, std::string_view(name).substr(id.size())) : "is not one of Rouleau's";
    if (!fault.empty()) faults.emplace(name, fault);
  }
  for (const auto& [name, fault] : faults) {
    const std::string subject = folder + '/' + name;
    Finding& finding = examination.add(Kind::leftover, subject, fault, "put it into lost+found");
    if (examination.options.mend) examination.put_away(finding, examination.data / subject);
  }
}

}  // namespace

void examine_files(Examination& examination) {
  const Owners owners(examination.database);
  examine_folder(examination, "archives", [&](const std::string& id, std::string_view suffix) {
    return fault_of_archive_file(owners, id, suffix);
  });
  examine_folder(examination, "logs", [&](const std::string& id, std::string_view suffix) -> std::string {
    return suffix == ".log" && owners.jobs.contains(id) ? "" : "is of no job";
  });
}

}  // namespace rouleau::storage
