#include <algorithm>

#include <SQLiteCpp/Statement.h>
#include <nlohmann/json.hpp>

#include "storage/archive_error.h"
#include "storage/archive_reader.h"
#include "storage/archive_writer.h"
#include "storage/checkup_parts.h"
#include "storage/job_store.h"
#include "storage/sha256.h"

namespace rouleau::storage {

namespace {

namespace fs = std::filesystem;
using Kind = Finding::Kind;

struct Expected {
  std::string id;
  std::uint64_t size = 0;
  std::string sha256;
  int jobs = 0;
};

std::vector<Expected> expected_archives(SQLite::Database& database) {
  std::vector<Expected> expected;
  SQLite::Statement select(database,
                           "SELECT archive_id, max(archive_size), max(archive_sha256), count(*) FROM jobs "
                           "WHERE archive_id IS NOT NULL GROUP BY archive_id ORDER BY archive_id");
  while (select.executeStep()) {
    expected.push_back({select.getColumn(0).getString(),
                        static_cast<std::uint64_t>(select.getColumn(1).getInt64()),
                        select.getColumn(2).getString(), select.getColumn(3).getInt()});
  }
  return expected;
}

/// What is wrong with an archive, or nothing.
std::string fault_of(const fs::path& file, const Expected& expected, bool deep) {
  std::error_code gone;
  const auto size = fs::file_size(file, gone);
  if (gone) return "is gone";
  if (size != expected.size) {
    return "has " + std::to_string(size) + " bytes, not " + std::to_string(expected.size);
  }
  try {
    if (ArchiveReader(file).summary().is_null()) return "was never finished";
  } catch (const ArchiveError& error) {
    return std::string("cannot be read: ") + error.what();
  }
  if (deep && sha256_hex_of_file(file) != expected.sha256)
    return "is not what was written: its SHA-256 differs";
  return {};
}

/// The jobs that had this archive have failed for what happened to it, so that they can be tried again.
void give_up_archive(SQLite::Database& database, const Expected& archive, const std::string& fault) {
  const nlohmann::json error{{"kind", "infrastructure"},
                             {"message", "the archive " + fault + "; retry the job to compute it again"}};
  SQLite::Statement update(database,
                           "UPDATE jobs SET state = 'failed', error = ?, summary = NULL, archive_id = NULL, "
                           "archive_size = NULL, archive_sha256 = NULL WHERE archive_id = ?");
  update.bind(1, error.dump());
  update.bind(2, archive.id);
  update.exec();
}

/// Several archives and not one of them there: rather a disk that is not mounted than so many losses.
bool all_are_gone(const fs::path& data, const std::vector<Expected>& archives) {
  return archives.size() > 1 && std::none_of(archives.begin(), archives.end(), [&](const Expected& archive) {
           std::error_code unknown;
           return fs::exists(data / "archives" / (archive.id + ".h5"), unknown) || unknown;
         });
}

}  // namespace

void examine_archives(Examination& examination) {
  const std::vector<Expected> archives = expected_archives(examination.database);
  if (all_are_gone(examination.data, archives)) {
    examination.add(Kind::damage, "archives",
                    "holds none of the " + std::to_string(archives.size()) + " archives that jobs have",
                    "see that its disk is mounted, or restore a backup");
    return;
  }
  for (const Expected& expected : archives) {
    const std::string name = "archives/" + expected.id + ".h5";
    const fs::path file = examination.data / name;
    ++examination.result.archives;
    examination.result.archive_bytes += expected.size;
    std::error_code unreadable;
    if (!fs::exists(file, unreadable) && unreadable) {
      examination.add(Kind::damage, name, unreadable.message(), "see what is wrong with the disk");
      continue;
    }
    const std::string fault = fault_of(file, expected, examination.options.deep);
    if (!fault.empty()) {
      const std::string jobs = std::to_string(expected.jobs) + (expected.jobs == 1 ? " job" : " jobs");
      Finding& finding =
          examination.add(Kind::lost, name, fault, "mark its " + jobs + " as failed, to be retried");
      if (examination.options.mend) {
        if (fs::exists(file)) examination.put_away(finding, file);
        give_up_archive(examination.database, expected, fault);
        finding.mended = true;
      }
    } else if (!fs::exists(sidecar_path(file))) {
      examination.add(Kind::note, sidecar_path(name).string(),
                      "is gone: ParaView cannot open this archive; all else can");
    }
  }
}

}  // namespace rouleau::storage
