#include "storage/job_store.h"

#include "storage/job_rows.h"
#include "storage/job_store_parts.h"
#include "storage/sqlite/connection.h"
#include "storage/sqlite/database.h"
#include "storage/sqlite/migrations.h"

namespace rouleau::storage {

namespace {

constexpr int reader_connections = 4;

std::filesystem::path made(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw StoreError(StoreError::Kind::io, folder.string() + ": " + error.message());
  return folder;
}

SQLite::Database opened(const std::filesystem::path& file) {
  try {
    SQLite::Database database = open_for_writing(file);
    migrate(database);
    return database;
  } catch (const SQLite::Exception& error) {
    throw StoreError(to_store_error(error).kind(), file.string() + ": " + error.what());
  }
}

}  // namespace

JobStore::Parts::Parts(const std::filesystem::path& folder, Clock time)
    : clock(std::move(time)),
      lock(made(folder)),
      writer(opened(folder / "jobs.sqlite")),
      readers(folder / "jobs.sqlite", reader_connections) {}

void bind_attempt(Prepared& statement, std::string_view id, int attempt) {
  statement.bind(":id", std::string(id));
  statement.bind(":attempt", attempt);
}

void bind_result(Prepared& statement, const JobResult& result, std::string_view archive_id) {
  statement.bind(":summary", result.summary);
  statement.bind(":size", result.archive_size);
  statement.bind(":sha256", result.archive_sha256);
  statement.bind(":archive", std::string(archive_id));
}

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
  const std::string newest = parts_->readers.run(
      [](Connection& db) { return db.execAndGet("SELECT max(id) FROM jobs").getString(); });
  parts_->ids.start_after(newest);
}

JobStore::~JobStore() = default;

std::optional<Job> JobStore::find(std::string_view id) {
  return parts_->readers.run([&](Connection& db) { return select_job(db, id); });
}

std::optional<CaseText> JobStore::case_text(std::string_view id) {
  return parts_->readers.run([&](Connection& db) { return select_case_text(db, id); });
}

JobPage JobStore::list(const JobQuery& query) {
  return parts_->readers.run([&](Connection& db) { return select_page(db, query); });
}

QueueState JobStore::queue_state() {
  return parts_->readers.run([](Connection& db) {
    QueueState queue;
    for (const JobState state : all_job_states) queue.counts[state] = 0;
    Prepared select(db, "SELECT state, count(*) FROM jobs INDEXED BY jobs_by_state GROUP BY state");
    while (select.executeStep()) {
      if (const auto state = parse_job_state(select.getColumn(0).getString())) {
        queue.counts[*state] = select.getColumn(1).getInt64();
      }
    }
    Prepared oldest(db,
                    "SELECT created_at FROM jobs INDEXED BY jobs_by_state WHERE state = 'queued' "
                    "ORDER BY id LIMIT 1");
    if (oldest.executeStep()) queue.oldest_waiting = oldest.getColumn(0).getInt64();
    queue.paused =
        Prepared(db, "SELECT 1 FROM settings WHERE name = 'queue' AND value = 'paused'").executeStep();
    return queue;
  });
}

}  // namespace rouleau::storage
