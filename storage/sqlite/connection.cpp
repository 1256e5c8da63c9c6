#include "storage/sqlite/connection.h"

namespace rouleau::storage {

namespace {

// More than there are statements in the program, but lists make theirs up as they are asked for.
constexpr std::size_t most_kept = 100;

}  // namespace

Connection::Kept Connection::take(const std::string& sql) {
  const auto found = idle_.find(sql);
  if (found == idle_.end()) return std::make_unique<SQLite::Statement>(*this, sql);
  Kept statement = std::move(found->second);
  idle_.erase(found);
  return statement;
}

void Connection::keep(const std::string& sql, Kept statement) {
  if (idle_.size() < most_kept) idle_.emplace(sql, std::move(statement));
}

Prepared::Prepared(Connection& connection, std::string sql)
    : connection_(connection), sql_(std::move(sql)), statement_(connection.take(sql_)) {}

Prepared::~Prepared() {
  statement_->tryReset();
  statement_->clearBindings();
  connection_.keep(sql_, std::move(statement_));
}

}  // namespace rouleau::storage
