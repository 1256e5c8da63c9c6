#include "storage/job_store.h"
#include "storage/job_store_parts.h"
#include "storage/sqlite/connection.h"

namespace rouleau::storage {

std::vector<EndedJob> JobStore::oldest_ended(int limit, const std::optional<EndedJob>& after) {
  return parts_->readers.run([&](Connection& db) {
    Prepared select(
        db,
        "SELECT id, ended_at, archive_id FROM jobs INDEXED BY jobs_by_end "
        "WHERE ended_at IS NOT NULL AND (ended_at, id) > (:ended_at, :id) "
        "AND (sweep IS NULL OR NOT EXISTS (SELECT 1 FROM jobs AS other WHERE other.sweep = jobs.sweep "
        "                                  AND other.ended_at IS NULL)) "
        "ORDER BY ended_at, id LIMIT :limit");
    select.bind(":ended_at", after ? after->ended_at : 0);
    select.bind(":id", after ? after->id : std::string());
    select.bind(":limit", limit);
    std::vector<EndedJob> jobs;
    while (select.executeStep()) {
      EndedJob job{select.getColumn(0).getString(), select.getColumn(1).getInt64(), {}};
      if (!select.getColumn(2).isNull()) job.archive_id = select.getColumn(2).getString();
      jobs.push_back(std::move(job));
    }
    return jobs;
  });
}

std::int64_t JobStore::archive_bytes() {
  return parts_->readers.run([](Connection& db) {
    Prepared select(db,
                    "SELECT coalesce(sum(size), 0) FROM (SELECT max(archive_size) AS size FROM jobs "
                    "WHERE archive_id IS NOT NULL GROUP BY archive_id)");
    select.executeStep();
    return select.getColumn(0).getInt64();
  });
}

}  // namespace rouleau::storage
