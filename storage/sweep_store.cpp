#include <algorithm>

#include "storage/job_rows.h"
#include "storage/job_store_parts.h"
#include "storage/job_submission.h"
#include "storage/result_reuse.h"
#include "storage/uuid.h"

namespace rouleau::storage {

namespace {

constexpr const char* sweep_columns = "SELECT id, name, labels, priority, created_at, given FROM sweeps ";

std::map<JobState, std::int64_t> counts_of(Connection& database, const std::string& sweep) {
  std::map<JobState, std::int64_t> counts;
  for (const JobState state : all_job_states) counts[state] = 0;
  Prepared select(database, "SELECT state, count(*) FROM jobs WHERE sweep = ? GROUP BY state");
  select.bind(1, sweep);
  while (select.executeStep()) {
    counts.at(parse_job_state(select.getColumn(0).getString()).value()) = select.getColumn(1).getInt64();
  }
  return counts;
}

Sweep sweep_of(const Prepared& row) {
  Sweep sweep;
  sweep.id = row.getColumn(0).getString();
  sweep.name = row.getColumn(1).getString();
  sweep.labels = row.getColumn(2).getString();
  sweep.priority = row.getColumn(3).getInt();
  sweep.created_at = row.getColumn(4).getInt64();
  sweep.given = row.getColumn(5).getString();
  return sweep;
}

std::optional<Sweep> select_sweep(Connection& database, std::string_view id) {
  std::optional<Sweep> sweep;
  {
    Prepared select(database, std::string(sweep_columns) + "WHERE id = ?");
    select.bind(1, std::string(id));
    if (select.executeStep()) sweep = sweep_of(select);
  }
  if (sweep) sweep->counts = counts_of(database, sweep->id);
  return sweep;
}

std::optional<SweepSubmission> sweep_of(Connection& database, const IdempotencyKey& key) {
  const auto id = find_keyed(database, key, "sweep");
  if (!id) return std::nullopt;
  return SweepSubmission{select_sweep(database, *id).value(), true};
}

void insert_sweep(Connection& database, const std::string& id, const NewSweep& submitted, TimeMs now) {
  Prepared insert(database,
                  "INSERT INTO sweeps (id, name, labels, lane, priority, given, created_at) "
                  "VALUES (?, ?, ?, ?, ?, ?, ?)");
  insert.bind(1, id);
  insert.bind(2, submitted.name);
  insert.bind(3, submitted.labels);
  insert.bind(4, submitted.lane);
  insert.bind(5, submitted.priority);
  insert.bind(6, submitted.given);
  insert.bind(7, now);
  insert.exec();
}

/// Those that run, and those that wait with something computed before.
CancelledJobs begun_jobs(Connection& database, std::string_view sweep) {
  Prepared select(database,
                  "SELECT id, state = 'running' FROM jobs WHERE sweep = ? AND attempt > 0 AND "
                  "state IN ('queued', 'running', 'paused')");
  select.bind(1, std::string(sweep));
  CancelledJobs jobs;
  while (select.executeStep()) {
    (select.getColumn(1).getInt() != 0 ? jobs.running : jobs.had_progress)
        .push_back(select.getColumn(0).getString());
  }
  return jobs;
}

}  // namespace

std::optional<SweepSubmission> JobStore::find_sweep_submission(const IdempotencyKey& key) {
  return parts_->readers.run([&](Connection& db) { return sweep_of(db, key); });
}

SweepSubmission JobStore::submit_sweep(const NewSweep& submitted, std::vector<NewJob> jobs,
                                       const std::optional<IdempotencyKey>& key) {
  return parts_->writer.run([&](Connection& db) {
    if (key) {
      if (auto earlier = sweep_of(db, *key)) return std::move(*earlier);
    }
    const TimeMs now = parts_->clock();
    const std::string id = parts_->ids.next(now);
    insert_sweep(db, id, submitted, now);
    int index = 0;
    for (NewJob& job : jobs) {
      job.place = SweepPlace{id, index++};
      insert_job(db, job, parts_->ids, now);
    }
    if (key) keep_key(db, *key, "sweep", id, now);
    return SweepSubmission{select_sweep(db, id).value(), false};
  });
}

std::optional<Sweep> JobStore::find_sweep(std::string_view id) {
  return parts_->readers.run([&](Connection& db) { return select_sweep(db, id); });
}

bool JobStore::sweep_is_active(std::string_view id) {
  return parts_->readers.run([&](Connection& db) {
    Prepared select(db,
                    "SELECT 1 FROM jobs WHERE sweep = ? AND "
                    "state IN ('queued', 'running', 'paused', 'cancelling') LIMIT 1");
    select.bind(1, std::string(id));
    return select.executeStep();
  });
}

std::vector<SweepJob> JobStore::sweep_jobs(std::string_view id, bool with_summaries) {
  return parts_->readers.run([&](Connection& db) {
    Prepared select(db, std::string("SELECT id, sweep_index, state, case_hash, ") +
                            (with_summaries ? "summary" : "NULL") +
                            " FROM jobs WHERE sweep = ? ORDER BY sweep_index");
    select.bind(1, std::string(id));
    std::vector<SweepJob> jobs;
    while (select.executeStep()) {
      SweepJob& job = jobs.emplace_back();
      job.id = select.getColumn(0).getString();
      job.index = select.getColumn(1).getInt();
      job.state = parse_job_state(select.getColumn(2).getString()).value();
      job.case_hash = select.getColumn(3).getString();
      if (const auto summary = select.getColumn(4); !summary.isNull()) job.summary = summary.getString();
    }
    return jobs;
  });
}

SweepPage JobStore::list_sweeps(int page_size, const std::string& page_token) {
  if (!page_token.empty() && !is_uuid(page_token)) {
    throw StoreError(StoreError::Kind::invalid_argument, "no page has this token");
  }
  const int most = std::clamp(page_size, 1, 1000);
  return parts_->readers.run([&](Connection& db) {
    SweepPage page;
    {
      Prepared select(db, std::string(sweep_columns) + "WHERE id < ? ORDER BY id DESC LIMIT ?");
      select.bind(1, page_token.empty() ? "g" : page_token);  // behind every id
      select.bind(2, most + 1);  // one more than shown tells whether there is a next page
      while (select.executeStep()) page.sweeps.push_back(sweep_of(select));
    }
    if (page.sweeps.size() > static_cast<std::size_t>(most)) {
      page.sweeps.pop_back();
      page.next_page_token = page.sweeps.back().id;
    }
    for (Sweep& sweep : page.sweeps) sweep.counts = counts_of(db, sweep.id);
    return page;
  });
}

CancelledJobs JobStore::request_cancel_sweep(std::string_view id) {
  return parts_->writer.run([&](Connection& db) {
    const CancelledJobs jobs = begun_jobs(db, id);
    Prepared update(db,
                    "UPDATE jobs SET ended_at = iif(state = 'running', NULL, :now), pause_requested = 0, "
                    "not_before = NULL, follows = NULL, "
                    "state = iif(state = 'running', 'cancelling', 'cancelled') "
                    "WHERE sweep = :id AND state IN ('queued', 'running', 'paused')");
    update.bind(":id", std::string(id));
    update.bind(":now", parts_->clock());
    update.exec();
    for (const std::string& leader : jobs.running) release_followers(db, leader);
    return jobs;
  });
}

}  // namespace rouleau::storage
