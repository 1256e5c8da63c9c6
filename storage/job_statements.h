#pragma once

#include <string>

namespace rouleau::storage {

/// What may be claimed at once. The index is named because the planner has others that look as good to it and
/// would sort all that waits for every claim.
inline constexpr const char* waiting =
    "FROM jobs INDEXED BY jobs_waiting WHERE state = 'queued' AND not_before IS NULL AND follows IS NULL ";

/// The highest priority that has waiting jobs, and the first of its lanes.
inline const std::string first_lane =
    std::string("SELECT priority, lane ") + waiting + "ORDER BY priority DESC, lane, id LIMIT 1";

/// The next lane of a :priority behind :lane.
inline const std::string next_lane =
    std::string("SELECT lane ") + waiting + "AND priority = :priority AND lane > :lane ORDER BY lane LIMIT 1";

inline const std::string oldest_of_lane = std::string("SELECT id, case_hash, fresh ") + waiting +
                                          "AND priority = :priority AND lane = :lane ORDER BY id LIMIT 1";

/// The job goes to :owner until :until.
inline constexpr const char* claim_job =
    "UPDATE jobs SET state = 'running', attempt = attempt + 1, started_at = :now, "
    "  lease_owner = :owner, lease_until = :until "
    "WHERE id = :id";

/// Takes a job from its holder: what ran waits again or is paused, what was being cancelled is cancelled.
/// Binds :not_before, :setback and :now.
inline constexpr const char* give_back =
    "UPDATE jobs SET "
    "  state = iif(state = 'cancelling', 'cancelled', iif(pause_requested, 'paused', 'queued')),"
    "  started_at = iif(state = 'cancelling', started_at, NULL),"
    "  not_before = iif(state = 'cancelling' OR pause_requested, NULL, :not_before),"
    "  ended_at = iif(state = 'cancelling', :now, NULL),"
    "  setbacks = setbacks + :setback, pause_requested = 0, lease_owner = NULL, lease_until = NULL "
    "WHERE lease_owner IS NOT NULL AND ";

/// What an attempt left behind; NULL where it is not bound.
inline constexpr const char* result_columns =
    "summary = :summary, archive_id = :archive, archive_size = :size, archive_sha256 = :sha256";

/// The end of an attempt by whoever still holds it. Binds :now, :id and :attempt.
inline std::string end_attempt(const std::string& assignments,
                               const std::string& from = "'running', 'cancelling'") {
  return "UPDATE jobs SET " + assignments +
         ", ended_at = :now, pause_requested = 0, lease_owner = NULL, lease_until = NULL "
         "WHERE id = :id AND attempt = :attempt AND state IN (" +
         from + ")";
}

}  // namespace rouleau::storage
