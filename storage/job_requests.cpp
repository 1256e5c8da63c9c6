#include <algorithm>
#include <initializer_list>

#include "storage/job_rows.h"
#include "storage/job_store_parts.h"
#include "storage/result_reuse.h"

namespace rouleau::storage {

namespace {

/// A change of a job's state that a client asks for.
struct Request {
  const char* assignments;
  const char* from;                           ///< the states that it is for
  std::initializer_list<JobState> done = {};  ///< states in which nothing is left to do
};

/// @return the job afterwards, none if there is no such job
/// @throws InvalidTransition
std::optional<Job> perform(Connection& database, std::string_view id, const Request& request, TimeMs now) {
  Prepared update(database, std::string("UPDATE jobs SET ") + request.assignments +
                                ", not_before = NULL, follows = NULL WHERE id = :id AND state IN (" +
                                request.from + ")");
  update.bind(":id", std::string(id));
  if (std::string_view(request.assignments).find(":now") != std::string_view::npos) update.bind(":now", now);
  const bool changed = update.exec() > 0;
  auto job = select_job(database, id);
  const auto& done = request.done;
  if (job && !changed && std::find(done.begin(), done.end(), job->state) == done.end()) {
    throw InvalidTransition(job->state);
  }
  if (changed) release_followers(database, id);
  return job;
}

/// Whether another job has the same archive.
bool is_shared(Connection& database, const std::string& archive_id, std::string_view but_for) {
  Prepared select(database, "SELECT 1 FROM jobs WHERE archive_id = ? AND id <> ? LIMIT 1");
  select.bind(1, archive_id);
  select.bind(2, std::string(but_for));
  return select.executeStep();
}

void leave_tombstone(Connection& database, std::string_view id, TimeMs now) {
  Prepared insert(database, "INSERT OR REPLACE INTO removed_jobs VALUES (?, ?)");
  insert.bind(1, std::string(id));
  insert.bind(2, now);
  insert.exec();
}

void forget_job(Connection& database, std::string_view id) {
  Prepared erase(database, "DELETE FROM jobs WHERE id = ?");
  erase.bind(1, std::string(id));
  erase.exec();
}

/// @return false: it still has jobs
bool forget_empty_sweep(Connection& database, const std::string& id) {
  Prepared erase(database,
                 "DELETE FROM sweeps WHERE id = ?1 AND NOT EXISTS (SELECT 1 FROM jobs WHERE sweep = ?1)");
  erase.bind(1, id);
  return erase.exec() > 0;
}

}  // namespace

std::optional<Job> JobStore::request_cancel(std::string_view id) {
  static const Request cancel{
      "ended_at = iif(state = 'running', NULL, :now), pause_requested = 0, "
      "state = iif(state = 'running', 'cancelling', 'cancelled')",
      "'queued', 'running', 'paused'",
      {JobState::cancelling, JobState::cancelled}};
  return parts_->writer.run([&](Connection& db) { return perform(db, id, cancel, parts_->clock()); });
}

std::optional<Job> JobStore::request_pause(std::string_view id) {
  static const Request pause{
      "pause_requested = iif(state = 'running', 1, 0), state = iif(state = 'running', 'running', 'paused')",
      "'queued', 'running'",
      {JobState::paused}};
  return parts_->writer.run([&](Connection& db) { return perform(db, id, pause, parts_->clock()); });
}

std::optional<Job> JobStore::resume(std::string_view id) {
  static const Request resume{"pause_requested = 0, state = iif(state = 'running', 'running', 'queued')",
                              "'paused', 'running'",
                              {JobState::queued}};
  return parts_->writer.run([&](Connection& db) { return perform(db, id, resume, parts_->clock()); });
}

std::optional<Job> JobStore::retry(std::string_view id) {
  static const Request retry{
      "state = 'queued', started_at = NULL, ended_at = NULL, error = NULL, setbacks = 0, progress = NULL, "
      "summary = NULL, archive_id = NULL, archive_size = NULL, archive_sha256 = NULL, result_of = NULL",
      "'failed', 'cancelled'"};
  return parts_->writer.run([&](Connection& db) { return perform(db, id, retry, parts_->clock()); });
}

std::optional<Removed> JobStore::remove(std::string_view id, Removal how) {
  return parts_->writer.run([&](Connection& db) -> std::optional<Removed> {
    const auto job = select_job(db, id);
    if (!job) return std::nullopt;
    if (!has_ended(job->state)) throw InvalidTransition(job->state);
    Removed removed;
    // One that failed with an archive and was tried again does not have it any more, but it is there.
    const std::string archive_id = job->archive_id.value_or(job->id);
    if (!is_shared(db, archive_id, id)) removed.archive_id = archive_id;
    forget_job(db, id);
    const bool sweep_goes = job->place && forget_empty_sweep(db, job->place->sweep);
    if (how == Removal::expired) {
      const TimeMs now = parts_->clock();
      leave_tombstone(db, id, now);
      if (sweep_goes) leave_tombstone(db, job->place->sweep, now);
    }
    return removed;
  });
}

bool JobStore::has_expired(std::string_view id) {
  return parts_->readers.run([&](Connection& db) {
    Prepared select(db, "SELECT 1 FROM removed_jobs WHERE id = ?");
    select.bind(1, std::string(id));
    return select.executeStep();
  });
}

void JobStore::pause_queue(bool paused) {
  parts_->writer.run([&](Connection& db) {
    Prepared set(db, "INSERT OR REPLACE INTO settings VALUES ('queue', ?)");
    set.bind(1, paused ? "paused" : "running");
    return set.exec();
  });
}

}  // namespace rouleau::storage
