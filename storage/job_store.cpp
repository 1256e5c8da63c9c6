#include "storage/job_store.h"

#include <SQLiteCpp/Statement.h>

#include "storage/job_rows.h"
#include "storage/job_statements.h"
#include "storage/sha256.h"
#include "storage/sqlite/database.h"
#include "storage/sqlite/folder_lock.h"
#include "storage/sqlite/group_writer.h"
#include "storage/sqlite/migrations.h"
#include "storage/sqlite/reader_pool.h"
#include "storage/uuid.h"

namespace rouleau::storage {

namespace {

using SQLite::Database;
using SQLite::Statement;

constexpr int reader_connections = 4;

void bind_attempt(Statement& statement, std::string_view id, int attempt) {
  statement.bind(":id", std::string(id));
  statement.bind(":attempt", attempt);
}

void bind_optional(Statement& statement, const char* name, const std::optional<TimeMs>& value) {
  if (value) statement.bind(name, *value);
}

void bind_result(Statement& statement, const JobResult& result) {
  statement.bind(":summary", result.summary);
  statement.bind(":size", result.archive_size);
  statement.bind(":sha256", result.archive_sha256);
}

std::filesystem::path made(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw StoreError(StoreError::Kind::io, folder.string() + ": " + error.message());
  return folder;
}

Database opened(const std::filesystem::path& file) {
  try {
    Database database = open_for_writing(file);
    migrate(database);
    return database;
  } catch (const SQLite::Exception& error) {
    throw StoreError(to_store_error(error).kind(), file.string() + ": " + error.what());
  }
}

void insert(Database& database, const Job& job, const NewJob& submitted) {
  Statement jobs(database,
                 "INSERT INTO jobs (id, state, name, case_hash, labels, priority, created_at) "
                 "VALUES (?, 'queued', ?, ?, ?, ?, ?)");
  jobs.bind(1, job.id);
  jobs.bind(2, job.name);
  jobs.bind(3, job.case_hash);
  jobs.bind(4, job.labels);
  jobs.bind(5, job.priority);
  jobs.bind(6, job.created_at);
  jobs.exec();
  Statement inputs(database, "INSERT INTO job_inputs VALUES (?, ?, ?, ?)");
  inputs.bind(1, job.id);
  inputs.bind(2, submitted.case_given);
  inputs.bind(3, submitted.case_resolved);
  inputs.bind(4, submitted.plan);
  inputs.exec();
}

}  // namespace

struct JobStore::Parts {
  Parts(const std::filesystem::path& folder, Clock time)
      : clock(std::move(time)),
        lock(made(folder)),
        writer(opened(folder / "jobs.sqlite")),
        readers(folder / "jobs.sqlite", reader_connections) {}

  Clock clock;
  FolderLock lock;
  GroupWriter writer;
  ReaderPool readers;
  UuidSource ids;  // the writer's alone, so that ids rise in the order of commits
};

TimeMs system_clock_ms() {
  const auto since_epoch = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::milliseconds>(since_epoch).count();
}

JobStore::JobStore(const std::filesystem::path& folder, Clock clock) {
  try {
    parts_ = std::make_unique<Parts>(folder, std::move(clock));
  } catch (const SQLite::Exception& error) {
    throw to_store_error(error);
  }
  const std::string newest =
      parts_->readers.run([](Database& db) { return db.execAndGet("SELECT max(id) FROM jobs").getString(); });
  parts_->ids.start_after(newest);
}

JobStore::~JobStore() = default;

Job JobStore::submit(NewJob submitted) {
  Job job;
  job.name = submitted.name;
  job.case_hash = sha256_hex(submitted.case_resolved);
  job.labels = submitted.labels;
  job.priority = submitted.priority;
  job.plan = submitted.plan;
  return parts_->writer.run([&](Database& db) {
    job.created_at = parts_->clock();
    job.id = parts_->ids.next(job.created_at);
    insert(db, job, submitted);
    return job;
  });
}

std::optional<Job> JobStore::find(std::string_view id) {
  return parts_->readers.run([&](Database& db) { return select_job(db, id); });
}

std::optional<CaseText> JobStore::case_text(std::string_view id) {
  return parts_->readers.run([&](Database& db) { return select_case_text(db, id); });
}

JobPage JobStore::list(const JobQuery& query) {
  return parts_->readers.run([&](Database& db) { return select_page(db, query); });
}

std::map<JobState, std::int64_t> JobStore::counts() {
  std::map<JobState, std::int64_t> counts;
  for (const JobState state : all_job_states) counts[state] = 0;
  parts_->readers.run([&](Database& db) {
    Statement select(db, "SELECT state, count(*) FROM jobs GROUP BY state");
    while (select.executeStep()) {
      if (const auto state = parse_job_state(select.getColumn(0).getString())) {
        counts[*state] = select.getColumn(1).getInt64();
      }
    }
    return true;
  });
  return counts;
}

std::optional<ClaimedJob> JobStore::claim(std::string_view owner, std::chrono::milliseconds lease) {
  return parts_->writer.run([&](Database& db) -> std::optional<ClaimedJob> {
    Statement update(db, claim_next);
    update.bind(":now", parts_->clock());
    update.bind(":owner", std::string(owner));
    update.bind(":lease", static_cast<std::int64_t>(lease.count()));
    if (!update.executeStep()) return std::nullopt;
    const std::string id = update.getColumn(0).getString();
    return ClaimedJob{select_job(db, id).value(), select_case_text(db, id).value()};
  });
}

Lease JobStore::renew(std::string_view id, int attempt, std::chrono::milliseconds lease,
                      const std::optional<std::string>& progress) {
  return parts_->writer.run([&](Database& db) {
    Statement update(db,
                     "UPDATE jobs SET lease_until = :until, progress = coalesce(:progress, progress) "
                     "WHERE id = :id AND attempt = :attempt AND lease_owner IS NOT NULL "
                     "RETURNING state = 'cancelling'");
    bind_attempt(update, id, attempt);
    update.bind(":until", parts_->clock() + static_cast<std::int64_t>(lease.count()));
    if (progress) update.bind(":progress", *progress);
    if (!update.executeStep()) return Lease::lost;
    return update.getColumn(0).getInt() != 0 ? Lease::cancel_requested : Lease::held;
  });
}

bool JobStore::succeed(std::string_view id, int attempt, const JobResult& result) {
  return parts_->writer.run([&](Database& db) {
    Statement update(db, end_attempt(std::string("state = 'succeeded', ") + result_columns));
    bind_attempt(update, id, attempt);
    update.bind(":now", parts_->clock());
    bind_result(update, result);
    return update.exec() > 0;
  });
}

bool JobStore::fail(std::string_view id, int attempt, const std::string& error,
                    const std::optional<JobResult>& result) {
  return parts_->writer.run([&](Database& db) {
    Statement update(db, end_attempt(std::string("state = 'failed', error = :error, ") + result_columns));
    bind_attempt(update, id, attempt);
    update.bind(":now", parts_->clock());
    update.bind(":error", error);
    if (result) bind_result(update, *result);
    return update.exec() > 0;
  });
}

bool JobStore::mark_cancelled(std::string_view id, int attempt) {
  return parts_->writer.run([&](Database& db) {
    Statement update(db, end_attempt("state = 'cancelled'", "'cancelling'"));
    bind_attempt(update, id, attempt);
    update.bind(":now", parts_->clock());
    return update.exec() > 0;
  });
}

bool JobStore::release(std::string_view id, int attempt, std::optional<TimeMs> not_before) {
  return parts_->writer.run([&](Database& db) {
    Statement update(db, std::string(give_back) + "id = :id AND attempt = :attempt");
    bind_attempt(update, id, attempt);
    bind_optional(update, ":not_before", not_before);
    update.bind(":now", parts_->clock());
    return update.exec() > 0;
  });
}

std::optional<Job> JobStore::request_cancel(std::string_view id) {
  return parts_->writer.run([&](Database& db) {
    Statement update(db,
                     "UPDATE jobs SET "
                     "  ended_at = iif(state = 'queued', :now, NULL), not_before = NULL,"
                     "  state = iif(state = 'queued', 'cancelled', 'cancelling') "
                     "WHERE id = :id AND state IN ('queued', 'running')");
    update.bind(":id", std::string(id));
    update.bind(":now", parts_->clock());
    update.exec();
    auto job = select_job(db, id);
    if (job && (job->state == JobState::succeeded || job->state == JobState::failed)) {
      throw InvalidTransition(job->state);
    }
    return job;
  });
}

int JobStore::recover(std::string_view owner) {
  return parts_->writer.run([&](Database& db) {
    Statement update(db, std::string(give_back) + "lease_owner <> :owner");
    update.bind(":owner", std::string(owner));
    update.bind(":now", parts_->clock());
    return update.exec();
  });
}

int JobStore::expire_leases() {
  return parts_->writer.run([&](Database& db) {
    Statement update(db, std::string(give_back) + "lease_until < :now");
    update.bind(":now", parts_->clock());
    return update.exec();
  });
}

}  // namespace rouleau::storage
