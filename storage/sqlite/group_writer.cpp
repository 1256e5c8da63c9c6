#include "storage/sqlite/group_writer.h"

#include <chrono>
#include <sqlite3.h>

#include <SQLiteCpp/Exception.h>

#include "storage/sqlite/database.h"

namespace rouleau::storage {

namespace {

constexpr std::chrono::milliseconds idle_before_checkpoint{500};
constexpr int busy_timeout_ms = 5000;
// About what a commit costs on a quick disk: no caller waits much longer for it, and a commit is shared by
// twice as many where clients ask again as soon as they are answered.
constexpr std::chrono::microseconds gathering_time{200};

void execute(Connection& database, const char* sql) {
  Prepared(database, sql).exec();
}

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

void GroupWriter::perform(std::function<void(Connection&)> work) {
  Write write{std::move(work), {}};
  std::shared_future<void> answered;
  bool enough = false;
  {
    const std::lock_guard lock(mutex_);
    waiting_.writes.push_back(&write);
    answered = waiting_.answered;
    enough = waiting_.writes.size() == wanted_;
  }
  if (enough) arrived_.notify_one();
  // Not a semaphore: GCC's yields the processor some times before it sleeps.
  answered.wait();
  if (write.error) std::rethrow_exception(write.error);
}

void GroupWriter::serve() {
  bool log_has_grown = false;
  std::size_t last_group = 0;
  const auto called = [this] { return stopping_ || !waiting_.writes.empty(); };
  std::unique_lock lock(mutex_);
  while (true) {
    gather(lock, last_group);
    if (!log_has_grown) {
      arrived_.wait(lock, called);
    } else if (!arrived_.wait_for(lock, idle_before_checkpoint, called)) {
      lock.unlock();
      checkpoint();
      lock.lock();
      log_has_grown = false;
      continue;
    }
    if (waiting_.writes.empty()) return;
    Group group = std::exchange(waiting_, {});
    lock.unlock();
    commit_group(group.writes);
    group.committed.set_value();
    last_group = group.writes.size();
    lock.lock();
    log_has_grown = true;
  }
}

void GroupWriter::gather(std::unique_lock<std::mutex>& lock, std::size_t last_group) {
  if (last_group < 2) return;
  wanted_ = waiting_.writes.size() + last_group;
  arrived_.wait_for(lock, gathering_time, [this] { return stopping_ || waiting_.writes.size() >= wanted_; });
  wanted_ = 1;
}

void GroupWriter::commit_group(const std::vector<Write*>& group) {
  try {
    execute(database_, "BEGIN IMMEDIATE");
    for (Write* const write : group) run_within_savepoint(*write);
    execute(database_, "COMMIT");
  } catch (const SQLite::Exception& error) {
    const auto failure = std::make_exception_ptr(to_store_error(error));
    roll_back(database_);
    for (Write* const write : group) {
      if (!write->error) write->error = failure;
    }
  }
}

void GroupWriter::run_within_savepoint(Write& write) {
  execute(database_, "SAVEPOINT one_write");
  try {
    write.work(database_);
  } catch (const SQLite::Exception& error) {
    write.error = std::make_exception_ptr(to_store_error(error));
    // A full disk and the like make SQLite undo the whole transaction: then the group has failed.
    if (!in_transaction(database_)) throw;
  } catch (...) {
    write.error = std::current_exception();
  }
  if (write.error) execute(database_, "ROLLBACK TO one_write");
  execute(database_, "RELEASE one_write");
}

void GroupWriter::checkpoint() {
  // Without waiting: a stranger's long read must not hold up the next write. What is left of the log then
  // is taken up after a later write.
  sqlite3_busy_timeout(database_.getHandle(), 0);
  sqlite3_wal_checkpoint_v2(database_.getHandle(), nullptr, SQLITE_CHECKPOINT_TRUNCATE, nullptr, nullptr);
  sqlite3_busy_timeout(database_.getHandle(), busy_timeout_ms);
}

}  // namespace rouleau::storage
