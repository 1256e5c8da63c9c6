#include "storage/result_reuse.h"

namespace rouleau::storage {

namespace {

constexpr const char* given_columns =
    "state = 'succeeded', ended_at = :now, not_before = NULL, follows = NULL, progress = source.progress, "
    "summary = source.summary, archive_id = source.archive_id, archive_size = source.archive_size, "
    "archive_sha256 = source.archive_sha256, result_of = coalesce(source.result_of, source.id) ";

std::optional<std::string> first_text(Prepared& select) {
  if (!select.executeStep()) return std::nullopt;
  return select.getColumn(0).getString();
}

}  // namespace

std::optional<std::string> job_with_result(Connection& database, std::string_view case_hash) {
  Prepared select(database,
                  "SELECT id FROM jobs INDEXED BY jobs_by_case "
                  "WHERE case_hash = ? AND state = 'succeeded' LIMIT 1");
  select.bind(1, std::string(case_hash));
  return first_text(select);
}

std::optional<std::string> job_on_the_way(Connection& database, std::string_view case_hash) {
  Prepared select(database,
                  "SELECT id FROM jobs INDEXED BY jobs_by_case "
                  "WHERE case_hash = ? AND state = 'running' AND pause_requested = 0 LIMIT 1");
  select.bind(1, std::string(case_hash));
  return first_text(select);
}

void give_result(Connection& database, std::string_view id, std::string_view source, TimeMs now) {
  Prepared update(database, std::string("UPDATE jobs SET ") + given_columns +
                                "FROM (SELECT * FROM jobs WHERE id = :source) AS source "
                                "WHERE jobs.id = :id AND jobs.state = 'queued'");
  update.bind(":id", std::string(id));
  update.bind(":source", std::string(source));
  update.bind(":now", now);
  update.exec();
}

void give_result_to_all(Connection& database, std::string_view source, TimeMs now) {
  Prepared update(database, std::string("UPDATE jobs SET ") + given_columns +
                                "FROM (SELECT * FROM jobs WHERE id = :source) AS source "
                                "WHERE jobs.case_hash = source.case_hash AND jobs.state = 'queued' AND "
                                "jobs.fresh = 0");
  update.bind(":source", std::string(source));
  update.bind(":now", now);
  update.exec();
}

void follow(Connection& database, std::string_view id, std::string_view leader) {
  Prepared update(database, "UPDATE jobs SET follows = :leader WHERE id = :id");
  update.bind(":id", std::string(id));
  update.bind(":leader", std::string(leader));
  update.exec();
}

void release_followers(Connection& database, std::string_view leader) {
  Prepared update(database, "UPDATE jobs SET follows = NULL WHERE follows = :leader");
  update.bind(":leader", std::string(leader));
  update.exec();
}

}  // namespace rouleau::storage
