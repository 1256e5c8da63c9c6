#include "storage/sqlite/group_writer.h"

#include <chrono>
#include <sqlite3.h>

#include <SQLiteCpp/Exception.h>

#include "storage/sqlite/database.h"

namespace rouleau::storage {

namespace {

constexpr std::chrono::milliseconds idle_before_checkpoint{500};
constexpr int busy_timeout_ms = 5000;

}  // namespace

GroupWriter::GroupWriter(SQLite::Database database)
    : database_(std::move(database)), thread_([this] { serve(); }) {}

GroupWriter::~GroupWriter() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  arrived_.notify_one();
  thread_.join();
}

void GroupWriter::perform(std::function<void(SQLite::Database&)> work) {
  Write write{std::move(work), nullptr, false};
  std::unique_lock lock(mutex_);
  waiting_.push_back(&write);
  arrived_.notify_one();
  answered_.wait(lock, [&] { return write.answered; });
  if (write.error) std::rethrow_exception(write.error);
}

void GroupWriter::serve() {
  bool log_has_grown = false;
  const auto called = [this] { return stopping_ || !waiting_.empty(); };
  std::unique_lock lock(mutex_);
  while (true) {
    if (!log_has_grown) {
      arrived_.wait(lock, called);
    } else if (!arrived_.wait_for(lock, idle_before_checkpoint, called)) {
      lock.unlock();
      checkpoint();
      lock.lock();
      log_has_grown = false;
      continue;
    }
    if (waiting_.empty()) return;
    const std::vector<Write*> group = std::exchange(waiting_, {});
    lock.unlock();
    commit_group(group);
    lock.lock();
    for (Write* write : group) write->answered = true;
    answered_.notify_all();
    log_has_grown = true;
  }
}

void GroupWriter::commit_group(const std::vector<Write*>& group) {
  try {
    database_.exec("BEGIN IMMEDIATE");
    for (Write* write : group) run_within_savepoint(*write);
    database_.exec("COMMIT");
  } catch (const SQLite::Exception& error) {
    const auto failure = std::make_exception_ptr(to_store_error(error));
    roll_back(database_);
    for (Write* write : group) {
      if (!write->error) write->error = failure;
    }
  }
}

void GroupWriter::run_within_savepoint(Write& write) {
  database_.exec("SAVEPOINT one_write");
  try {
    write.work(database_);
  } catch (const SQLite::Exception& error) {
    write.error = std::make_exception_ptr(to_store_error(error));
    // A full disk and the like make SQLite undo the whole transaction: then the group has failed.
    if (!in_transaction(database_)) throw;
  } catch (...) {
    write.error = std::current_exception();
  }
  if (write.error) database_.exec("ROLLBACK TO one_write");
  database_.exec("RELEASE one_write");
}

void GroupWriter::checkpoint() {
  // Without waiting: a stranger's long read must not hold up the next write. What is left of the log then
  // is taken up after a later write.
  sqlite3_busy_timeout(database_.getHandle(), 0);
  sqlite3_wal_checkpoint_v2(database_.getHandle(), nullptr, SQLITE_CHECKPOINT_TRUNCATE, nullptr, nullptr);
  sqlite3_busy_timeout(database_.getHandle(), busy_timeout_ms);
}

}  // namespace rouleau::storage
