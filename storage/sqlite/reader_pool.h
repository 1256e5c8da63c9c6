#pragma once

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <utility>
#include <vector>

#include "storage/sqlite/connection.h"
#include "storage/sqlite/database.h"

namespace rouleau::storage {

/// A few read-only connections, lent for one short read each: a read that lasts keeps the log from being
/// taken up, and it grows without bound.
class ReaderPool {
 public:
  ReaderPool(const std::filesystem::path& file, int connections);

  /// Runs `read(connection)`, which must leave no statement open.
  /// @throws StoreError
  template <class Read>
  auto run(Read&& read) {
    Loan loan(*this);
    try {
      return read(loan.database);
    } catch (const SQLite::Exception& error) {
      throw to_store_error(error);
    }
  }

 private:
  struct Loan {
    explicit Loan(ReaderPool& from) : pool(from), database(from.take()) {}
    ~Loan() { pool.give_back(std::move(database)); }
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;

    ReaderPool& pool;
    Connection database;
  };

  Connection take();
  void give_back(Connection database);

  std::mutex mutex_;
  std::condition_variable returned_;
  std::vector<Connection> idle_;
};

}  // namespace rouleau::storage
