#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

namespace rouleau::storage {

/// A database together with the statements prepared on it: to prepare one takes as long as to run it.
class Connection : public SQLite::Database {
 public:
  explicit Connection(SQLite::Database database) : SQLite::Database(std::move(database)) {}

 private:
  friend class Prepared;
  using Kept = std::unique_ptr<SQLite::Statement>;

  Kept take(const std::string& sql);
  void keep(const std::string& sql, Kept statement);

  std::unordered_map<std::string, Kept> idle_;  // gone before the database is closed
};

/// A statement lent by its connection while this lives; it goes back without its values.
class Prepared {
 public:
  Prepared(Connection& connection, std::string sql);
  ~Prepared();
  Prepared(const Prepared&) = delete;
  Prepared& operator=(const Prepared&) = delete;

  template <class Place, class... Value>
  void bind(Place place, Value&&... value) {
    statement_->bind(place, std::forward<Value>(value)...);
  }
  /// @return how many rows it changed
  int exec() { return statement_->exec(); }
  bool executeStep() { return statement_->executeStep(); }
  /// To be run again, perhaps with other values.
  void reset() { statement_->reset(); }
  SQLite::Column getColumn(int index) const { return statement_->getColumn(index); }

  SQLite::Statement& statement() { return *statement_; }

 private:
  Connection& connection_;
  const std::string sql_;
  Connection::Kept statement_;
};

}  // namespace rouleau::storage
