#include "storage/sqlite/group_writer.h"

#include <atomic>
#include <future>
#include <sqlite3.h>
#include <thread>
#include <vector>

#include <SQLiteCpp/Statement.h>
#include <gtest/gtest.h>

#include "storage/sqlite/database.h"
#include "storage/sqlite/reader_pool.h"
#include "tests/unit/storage/scratch.h"

namespace rouleau::storage {
namespace {

int count_commit(void* counter) {
  ++*static_cast<std::atomic<int>*>(counter);
  return 0;
}

class GroupWriting : public testing::Test {
 protected:
  GroupWriting() : file(folder.path() / "numbers.sqlite"), writer(prepared()) {}

  SQLite::Database prepared() {
    SQLite::Database database = open_for_writing(file);
    database.exec("CREATE TABLE numbers (n INTEGER NOT NULL UNIQUE) STRICT");
    sqlite3_commit_hook(database.getHandle(), count_commit, &commits);
    return database;
  }

  void insert(int n) {
    writer.run([n](SQLite::Database& db) {
      return db.exec("INSERT INTO numbers VALUES (" + std::to_string(n) + ")");
    });
  }

  /// Keeps the writer busy until `release` is called; what is asked for meanwhile waits for the next group.
  std::thread hold() {
    std::promise<void> held;
    std::thread holder([this, &held] {
      writer.run([this, &held](SQLite::Database&) {
        held.set_value();
        return gate.get_future().wait(), true;
      });
    });
    held.get_future().wait();
    return holder;
  }

  int stored() {
    return ReaderPool(file, 1).run(
        [](SQLite::Database& db) { return db.execAndGet("SELECT count(*) FROM numbers").getInt(); });
  }

  ScratchFolder folder;
  std::filesystem::path file;
  std::atomic<int> commits = 0;
  std::promise<void> gate;
  GroupWriter writer;
};

TEST_F(GroupWriting, EightCallersShareACommit) {
  std::thread holder = hold();
  std::vector<std::thread> callers;
  for (int i = 0; i < 8; ++i) callers.emplace_back([this, i] { insert(i); });
  std::this_thread::sleep_for(std::chrono::milliseconds(200));  // for all eight to be waiting
  gate.set_value();
  holder.join();
  for (auto& caller : callers) caller.join();
  EXPECT_EQ(stored(), 8);
  // Two if all eight were waiting, more if a busy machine kept some from it; nine if each had its own.
  EXPECT_LE(commits, 6);
}

TEST_F(GroupWriting, OneThatFailsDoesNotSpoilTheOthers) {
  insert(3);
  std::thread holder = hold();
  std::vector<std::thread> callers;
  std::atomic<int> refused = 0;
  for (int i = 0; i < 8; ++i) {
    callers.emplace_back([this, i, &refused] {
      try {
        insert(i);
      } catch (const StoreError& error) {
        EXPECT_EQ(error.kind(), StoreError::Kind::invalid_argument);
        EXPECT_EQ(i, 3) << error.what();
        ++refused;
      }
    });
  }
  gate.set_value();
  holder.join();
  for (auto& caller : callers) caller.join();
  EXPECT_EQ(refused, 1);
  EXPECT_EQ(stored(), 8);
}

TEST_F(GroupWriting, WhatTheWorkThrowsUndoesItAndComesBack) {
  EXPECT_THROW(writer.run([](SQLite::Database& db) -> int {
    db.exec("INSERT INTO numbers VALUES (1)");
    throw std::out_of_range("mine");
  }),
               std::out_of_range);
  EXPECT_EQ(stored(), 0);
  insert(1);
  EXPECT_EQ(stored(), 1);
}

TEST_F(GroupWriting, AnAnswerComesAfterItsCommit) {
  for (int i = 0; i < 20; ++i) {
    insert(i);
    ASSERT_EQ(stored(), i + 1);
  }
}

TEST_F(GroupWriting, ReadersCannotWrite) {
  ReaderPool readers(file, 1);
  EXPECT_THROW(readers.run([](SQLite::Database& db) { return db.exec("DELETE FROM numbers"); }), StoreError);
  EXPECT_EQ(readers.run([](SQLite::Database&) { return 7; }), 7) << "the connection came back to the pool";
}

TEST_F(GroupWriting, TheLogIsTakenUpWhenIdle) {
  for (int i = 0; i < 20; ++i) insert(i);
  const auto log = file.string() + "-wal";
  EXPECT_GT(std::filesystem::file_size(log), 0u);
  for (int i = 0; i < 100 && std::filesystem::file_size(log) > 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  EXPECT_EQ(std::filesystem::file_size(log), 0u);
  EXPECT_EQ(stored(), 20);
}

}  // namespace
}  // namespace rouleau::storage
