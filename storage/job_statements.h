#pragma once

#include <string>

namespace rouleau::storage {

/// The job whose turn it is goes to :owner until :now + :lease; returns its id. The index is named because
/// the planner has another that looks as good to it and would sort all that waits for every claim.
inline constexpr const char* claim_next =
    "UPDATE jobs SET state = 'running', attempt = attempt + 1, started_at = :now, not_before = NULL, "
    "  lease_owner = :owner, lease_until = :now + :lease "
    "WHERE id = (SELECT id FROM jobs INDEXED BY jobs_waiting "
    "            WHERE state = 'queued' AND (not_before IS NULL OR not_before <= :now) "
    "            ORDER BY priority DESC, id LIMIT 1) "
    "RETURNING id";

/// Takes a job from its holder: what ran waits again, from the start; what was being cancelled is cancelled.
/// Binds :now and :not_before.
inline constexpr const char* give_back =
    "UPDATE jobs SET "
    "  state = iif(state = 'running', 'queued', 'cancelled'),"
    "  started_at = iif(state = 'running', NULL, started_at),"
    "  progress = iif(state = 'running', NULL, progress),"
    "  not_before = iif(state = 'running', :not_before, NULL),"
    "  ended_at = iif(state = 'running', NULL, :now),"
    "  lease_owner = NULL, lease_until = NULL "
    "WHERE lease_owner IS NOT NULL AND ";

/// What an attempt left behind; NULL where it is not bound.
inline constexpr const char* result_columns =
    "summary = :summary, archive_size = :size, archive_sha256 = :sha256";

/// The end of an attempt by whoever still holds it. Binds :now, :id and :attempt.
inline std::string end_attempt(const std::string& assignments,
                               const std::string& from = "'running', 'cancelling'") {
  return "UPDATE jobs SET " + assignments +
         ", ended_at = :now, lease_owner = NULL, lease_until = NULL "
         "WHERE id = :id AND attempt = :attempt AND state IN (" +
         from + ")";
}

}  // namespace rouleau::storage
