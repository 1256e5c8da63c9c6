#include "storage/job_rows.h"
#include "storage/job_statements.h"
#include "storage/job_store_parts.h"
#include "storage/result_reuse.h"

namespace rouleau::storage {

namespace {

struct Candidate {
  std::string id, case_hash;
  bool fresh = false;
};

bool queue_is_paused(Connection& database) {
  return Prepared(database, "SELECT 1 FROM settings WHERE name = 'queue' AND value = 'paused'").executeStep();
}

// No gap before another attempt is longer; a time beyond it was set before the clock stepped back.
constexpr TimeMs longest_delay = 600'000;

/// Jobs whose time has come wait like all others.
void end_delays(Connection& database, TimeMs now) {
  Prepared update(database,
                  "UPDATE jobs SET not_before = NULL "
                  "WHERE not_before IS NOT NULL AND (not_before <= :now OR not_before > :latest)");
  update.bind(":now", now);
  update.bind(":latest", now + longest_delay);
  update.exec();
}

/// Of the lanes that wait at the highest priority the one that was served longest ago, and its oldest job.
std::optional<Candidate> next_candidate(Connection& database,
                                        const std::map<std::string, std::uint64_t>& turns) {
  Prepared first(database, first_lane);
  if (!first.executeStep()) return std::nullopt;
  const int priority = first.getColumn(0).getInt();
  const auto turn_of = [&](const std::string& lane) {
    const auto known = turns.find(lane);
    return known == turns.end() ? 0 : known->second;
  };
  std::string lane = first.getColumn(1).getString(), chosen = lane;
  while (turn_of(chosen) > 0) {
    Prepared next(database, next_lane);
    next.bind(":priority", priority);
    next.bind(":lane", lane);
    if (!next.executeStep()) break;
    lane = next.getColumn(0).getString();
    if (turn_of(lane) < turn_of(chosen)) chosen = lane;
  }
  Prepared oldest(database, oldest_of_lane);
  oldest.bind(":priority", priority);
  oldest.bind(":lane", chosen);
  oldest.executeStep();
  return Candidate{oldest.getColumn(0).getString(), oldest.getColumn(1).getString(),
                   oldest.getColumn(2).getInt() != 0};
}

/// Whether a job need not run, for its result is there or on its way.
bool spared(Connection& database, const Candidate& job, TimeMs now, bool& gave_result) {
  if (job.fresh) return false;
  if (const auto source = job_with_result(database, job.case_hash)) {
    give_result(database, job.id, *source, now);
    gave_result = true;
    return true;
  }
  if (const auto leader = job_on_the_way(database, job.case_hash)) {
    follow(database, job.id, *leader);
    return true;
  }
  return false;
}

bool end_without_result(Connection& database, Prepared& update, std::string_view id) {
  const bool ended = update.exec() > 0;
  if (ended) release_followers(database, id);
  return ended;
}

}  // namespace

std::optional<ClaimedJob> JobStore::claim(std::string_view owner, std::chrono::milliseconds lease,
                                          bool* gave_results) {
  bool gave = false;
  const auto claimed = parts_->writer.run([&](Connection& db) -> std::optional<ClaimedJob> {
    if (queue_is_paused(db)) return std::nullopt;
    const TimeMs now = parts_->clock();
    end_delays(db, now);
    auto candidate = next_candidate(db, parts_->turns);
    while (candidate && spared(db, *candidate, now, gave)) candidate = next_candidate(db, parts_->turns);
    if (!candidate) return std::nullopt;
    Prepared update(db, claim_job);
    update.bind(":id", candidate->id);
    update.bind(":now", now);
    update.bind(":owner", std::string(owner));
    update.bind(":until", now + static_cast<std::int64_t>(lease.count()));
    update.exec();
    ClaimedJob taken{select_job(db, candidate->id).value(), select_case_text(db, candidate->id).value()};
    parts_->turns[taken.job.lane] = ++parts_->last_turn;
    return taken;
  });
  if (gave_results != nullptr) *gave_results = gave;
  return claimed;
}

Lease JobStore::renew(std::string_view id, int attempt, std::chrono::milliseconds lease,
                      const std::optional<std::string>& progress) {
  return parts_->writer.run([&](Connection& db) {
    Prepared update(db,
                    "UPDATE jobs SET lease_until = :until, progress = coalesce(:progress, progress) "
                    "WHERE id = :id AND attempt = :attempt AND lease_owner IS NOT NULL "
                    "RETURNING state = 'cancelling', pause_requested");
    bind_attempt(update, id, attempt);
    update.bind(":until", parts_->clock() + static_cast<std::int64_t>(lease.count()));
    if (progress) update.bind(":progress", *progress);
    if (!update.executeStep()) return Lease::lost;
    if (update.getColumn(0).getInt() != 0) return Lease::cancel_requested;
    return update.getColumn(1).getInt() != 0 ? Lease::pause_requested : Lease::held;
  });
}

bool JobStore::note_checkpoint(std::string_view id, int attempt) {
  return parts_->writer.run([&](Connection& db) {
    Prepared update(db,
                    "UPDATE jobs SET setbacks = 0 "
                    "WHERE id = :id AND attempt = :attempt AND lease_owner IS NOT NULL");
    bind_attempt(update, id, attempt);
    return update.exec() > 0;
  });
}

bool JobStore::succeed(std::string_view id, int attempt, const JobResult& result) {
  return parts_->writer.run([&](Connection& db) {
    Prepared update(db, end_attempt(std::string("state = 'succeeded', ") + result_columns));
    const TimeMs now = parts_->clock();
    bind_attempt(update, id, attempt);
    update.bind(":now", now);
    bind_result(update, result, id);
    const bool ended = update.exec() > 0;
    if (ended) give_result_to_all(db, id, now);
    return ended;
  });
}

bool JobStore::fail(std::string_view id, int attempt, const std::string& error,
                    const std::optional<JobResult>& result) {
  return parts_->writer.run([&](Connection& db) {
    Prepared update(db, end_attempt(std::string("state = 'failed', error = :error, ") + result_columns));
    bind_attempt(update, id, attempt);
    update.bind(":now", parts_->clock());
    update.bind(":error", error);
    if (result) bind_result(update, *result, id);
    return end_without_result(db, update, id);
  });
}

bool JobStore::mark_cancelled(std::string_view id, int attempt) {
  return parts_->writer.run([&](Connection& db) {
    Prepared update(db, end_attempt("state = 'cancelled'", "'cancelling'"));
    bind_attempt(update, id, attempt);
    update.bind(":now", parts_->clock());
    return end_without_result(db, update, id);
  });
}

bool JobStore::release(std::string_view id, int attempt, std::optional<TimeMs> not_before) {
  return parts_->writer.run([&](Connection& db) {
    Prepared update(db, std::string(give_back) + "id = :id AND attempt = :attempt");
    bind_attempt(update, id, attempt);
    if (not_before) update.bind(":not_before", *not_before);
    update.bind(":setback", not_before ? 1 : 0);
    update.bind(":now", parts_->clock());
    return end_without_result(db, update, id);
  });
}

int JobStore::recover(std::string_view owner) {
  return parts_->writer.run([&](Connection& db) {
    Prepared unfollow(db, "UPDATE jobs SET follows = NULL WHERE follows IS NOT NULL");
    unfollow.exec();
    Prepared update(db, std::string(give_back) + "lease_owner <> :owner");
    update.bind(":owner", std::string(owner));
    update.bind(":setback", 1);
    update.bind(":now", parts_->clock());
    return update.exec();
  });
}

int JobStore::expire_leases() {
  return parts_->writer.run([&](Connection& db) {
    const TimeMs now = parts_->clock();
    Prepared unfollow(db,
                      "UPDATE jobs SET follows = NULL WHERE follows IN "
                      "(SELECT id FROM jobs INDEXED BY jobs_held WHERE lease_owner IS NOT NULL AND "
                      "lease_until < ?)");
    unfollow.bind(1, now);
    unfollow.exec();
    Prepared update(db, std::string(give_back) + "lease_until < :now");
    update.bind(":setback", 1);
    update.bind(":now", now);
    return update.exec();
  });
}

}  // namespace rouleau::storage
