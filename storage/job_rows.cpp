#include "storage/job_rows.h"

#include <algorithm>

#include "storage/store_error.h"
#include "storage/uuid.h"

namespace rouleau::storage {

namespace {

constexpr std::string_view job_columns =
    "SELECT id, state, name, case_hash, labels, lane, priority, fresh, sweep, sweep_index, follows, "
    "result_of, "
    "attempt, setbacks, pause_requested, created_at, started_at, ended_at, not_before, progress, plan, "
    "summary, "
    "error, archive_id, archive_size, archive_sha256 "
    "FROM jobs JOIN job_inputs ON job_id = id ";

std::optional<std::int64_t> optional_integer(const SQLite::Column& column) {
  if (column.isNull()) return std::nullopt;
  return column.getInt64();
}

std::optional<std::string> optional_text(const SQLite::Column& column) {
  if (column.isNull()) return std::nullopt;
  return column.getString();
}

JobState state_of(const SQLite::Column& column) {
  const auto state = parse_job_state(column.getString());
  if (!state) throw StoreError(StoreError::Kind::corrupt, "database: a job in no known state");
  return *state;
}

Job job_of(const Prepared& row) {
  int column = 0;
  const auto next = [&] { return row.getColumn(column++); };
  Job job;
  job.id = next().getString();
  job.state = state_of(next());
  job.name = next().getString();
  job.case_hash = next().getString();
  job.labels = next().getString();
  job.lane = next().getString();
  job.priority = next().getInt();
  job.fresh = next().getInt() != 0;
  const auto sweep = optional_text(next());
  const int index = next().getInt();
  if (sweep) job.place = SweepPlace{*sweep, index};
  job.follows = optional_text(next());
  job.result_of = optional_text(next());
  job.attempt = next().getInt();
  job.setbacks = next().getInt();
  job.pause_requested = next().getInt() != 0;
  job.created_at = next().getInt64();
  job.started_at = optional_integer(next());
  job.ended_at = optional_integer(next());
  job.not_before = optional_integer(next());
  job.progress = optional_text(next());
  job.plan = next().getString();
  job.summary = optional_text(next());
  job.error = optional_text(next());
  job.archive_id = optional_text(next());
  job.archive_size = optional_integer(next());
  job.archive_sha256 = optional_text(next());
  return job;
}

std::string page_statement(const JobQuery& query) {
  std::string sql(job_columns);
  sql += "WHERE true ";
  if (!query.page_token.empty()) sql += "AND id < ? ";
  if (!query.states.empty()) {
    sql += "AND state IN (?";
    for (std::size_t i = 1; i < query.states.size(); ++i) sql += ", ?";
    sql += ") ";
  }
  if (!query.sweep.empty()) sql += "AND sweep = ? ";
  for (std::size_t i = 0; i < query.labels.size(); ++i) {
    sql += "AND EXISTS (SELECT 1 FROM json_each(labels) AS label WHERE label.key = ? AND label.value = ?) ";
  }
  return sql + "ORDER BY id DESC LIMIT ?";
}

}  // namespace

std::optional<Job> select_job(Connection& database, std::string_view id) {
  Prepared select(database, std::string(job_columns) + "WHERE id = ?");
  select.bind(1, std::string(id));
  if (!select.executeStep()) return std::nullopt;
  return job_of(select);
}

std::optional<CaseText> select_case_text(Connection& database, std::string_view id) {
  Prepared select(database, "SELECT case_given, case_resolved FROM job_inputs WHERE job_id = ?");
  select.bind(1, std::string(id));
  if (!select.executeStep()) return std::nullopt;
  return CaseText{select.getColumn(0).getString(), select.getColumn(1).getString()};
}

JobPage select_page(Connection& database, const JobQuery& query) {
  if (!query.page_token.empty() && !is_uuid(query.page_token)) {
    throw StoreError(StoreError::Kind::invalid_argument, "no page has this token");
  }
  const int page_size = std::clamp(query.page_size, 1, 1000);
  Prepared select(database, page_statement(query));
  int index = 1;
  if (!query.page_token.empty()) select.bind(index++, query.page_token);
  for (const JobState state : query.states) select.bind(index++, std::string(to_string(state)));
  if (!query.sweep.empty()) select.bind(index++, query.sweep);
  for (const auto& [key, value] : query.labels) {
    select.bind(index++, key);
    select.bind(index++, value);
  }
  select.bind(index, page_size + 1);  // one more than shown tells whether there is a next page

  JobPage page;
  while (select.executeStep()) page.jobs.push_back(job_of(select));
  if (page.jobs.size() > static_cast<std::size_t>(page_size)) {
    page.jobs.pop_back();
    page.next_page_token = page.jobs.back().id;
  }
  return page;
}

}  // namespace rouleau::storage
