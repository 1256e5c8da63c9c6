#include "storage/job_submission.h"

#include "storage/job_rows.h"
#include "storage/job_store_parts.h"
#include "storage/result_reuse.h"

namespace rouleau::storage {

namespace {

void insert_inputs(Connection& database, const std::string& id, const NewJob& submitted) {
  Prepared inputs(database, "INSERT INTO job_inputs VALUES (?, ?, ?, ?)");
  inputs.bind(1, id);
  inputs.bind(2, submitted.case_given);
  inputs.bind(3, submitted.case_resolved);
  inputs.bind(4, submitted.plan);
  inputs.exec();
}

std::optional<Submission> job_of(Connection& database, const IdempotencyKey& key) {
  const auto id = find_keyed(database, key, "job");
  if (!id) return std::nullopt;
  return Submission{select_job(database, *id).value(), true};
}

}  // namespace

std::string insert_job(Connection& database, const NewJob& submitted, UuidSource& ids, TimeMs now) {
  const std::string id = ids.next(now);
  Prepared jobs(
      database,
      "INSERT INTO jobs (id, state, name, case_hash, labels, lane, priority, sweep, sweep_index, "
      "fresh, created_at) "
      "VALUES (:id, 'queued', :name, :hash, :labels, :lane, :priority, :sweep, :index, :fresh, :now)");
  jobs.bind(":id", id);
  jobs.bind(":name", submitted.name);
  jobs.bind(":hash", submitted.case_hash);
  jobs.bind(":labels", submitted.labels);
  jobs.bind(":lane", submitted.lane);
  jobs.bind(":priority", submitted.priority);
  if (submitted.place) {
    jobs.bind(":sweep", submitted.place->sweep);
    jobs.bind(":index", submitted.place->index);
  }
  jobs.bind(":fresh", submitted.fresh ? 1 : 0);
  jobs.bind(":now", now);
  jobs.exec();
  insert_inputs(database, id, submitted);
  if (submitted.fresh) return id;
  if (const auto source = job_with_result(database, submitted.case_hash)) {
    give_result(database, id, *source, now);
  } else if (const auto leader = job_on_the_way(database, submitted.case_hash)) {
    follow(database, id, *leader);
  }
  return id;
}

std::optional<std::string> find_keyed(Connection& database, const IdempotencyKey& key, const char* column) {
  Prepared select(database, std::string("SELECT fingerprint, ") + column +
                                " FROM idempotency_keys WHERE caller = ? AND key = ?");
  select.bind(1, key.caller);
  select.bind(2, key.key);
  if (!select.executeStep()) return std::nullopt;
  if (select.getColumn(0).getString() != key.fingerprint || select.getColumn(1).isNull()) {
    throw IdempotencyMismatch();
  }
  return select.getColumn(1).getString();
}

void keep_key(Connection& database, const IdempotencyKey& key, const char* column, const std::string& id,
              TimeMs now) {
  Prepared insert(
      database, std::string("INSERT INTO idempotency_keys (caller, key, fingerprint, created_at, ") + column +
                    ") VALUES (?, ?, ?, ?, ?)");
  insert.bind(1, key.caller);
  insert.bind(2, key.key);
  insert.bind(3, key.fingerprint);
  insert.bind(4, now);
  insert.bind(5, id);
  insert.exec();
}

std::optional<Submission> JobStore::find_submission(const IdempotencyKey& key) {
  return parts_->readers.run([&](Connection& db) { return job_of(db, key); });
}

Submission JobStore::submit(NewJob submitted, const std::optional<IdempotencyKey>& key) {
  return parts_->writer.run([&](Connection& db) {
    if (key) {
      if (auto earlier = job_of(db, *key)) return std::move(*earlier);
    }
    const TimeMs now = parts_->clock();
    const std::string id = insert_job(db, submitted, parts_->ids, now);
    if (key) keep_key(db, *key, "job", id, now);
    return Submission{select_job(db, id).value(), false};
  });
}

int JobStore::forget_keys(TimeMs before) {
  return parts_->writer.run([&](Connection& db) {
    Prepared erase(db, "DELETE FROM idempotency_keys WHERE created_at < ?");
    erase.bind(1, before);
    return erase.exec();
  });
}

}  // namespace rouleau::storage
