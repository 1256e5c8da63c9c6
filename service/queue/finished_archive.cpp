#include "service/queue/finished_archive.h"

#include <cstdint>

#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "engine/simulation/run.h"
#include "storage/archive_reader.h"
#include "storage/sha256.h"

namespace rouleau::service {

std::optional<storage::JobResult> finished_result(const std::filesystem::path& archive,
                                                  const Case& resolved) {
  if (!std::filesystem::exists(archive)) return std::nullopt;
  try {
    const storage::ArchiveReader reader(archive);
    const nlohmann::json summary = reader.summary();
    const bool completed = summary.is_object() && summary.value("ending", "") == "completed";
    if (!completed || reader.version() != engine_version() || reader.case_resolved() != to_json(resolved)) {
      return std::nullopt;
    }
    return storage::JobResult{summary.dump(), static_cast<std::int64_t>(std::filesystem::file_size(archive)),
                              storage::sha256_hex_of_file(archive)};
  } catch (const storage::ArchiveError&) {
    return std::nullopt;
  }
}

}  // namespace rouleau::service
