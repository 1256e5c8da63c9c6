#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include <SQLiteCpp/Database.h>

namespace rouleau::storage {

/// The only thread that writes. Whatever waits when it turns to the next transaction shares that one commit,
/// and each caller is answered after it: at `synchronous = FULL` a commit costs a sync, so eight callers at
/// once are served about eight times as fast as by eight connections.
class GroupWriter {
 public:
  explicit GroupWriter(SQLite::Database database);
  /// Serves those who wait, then ends.
  ~GroupWriter();
  GroupWriter(const GroupWriter&) = delete;
  GroupWriter& operator=(const GroupWriter&) = delete;

  /// Runs `work(database)` in the next transaction and returns its result once that is on the disk. What it
  /// throws undoes this work alone and comes back to the caller.
  /// @throws StoreError if the work or the commit fails; then nothing of this work is stored
  template <class Work>
  auto run(Work&& work) {
    std::optional<std::invoke_result_t<Work&, SQLite::Database&>> result;
    perform([&](SQLite::Database& database) { result.emplace(work(database)); });
    return std::move(*result);
  }

 private:
  struct Write {
    std::function<void(SQLite::Database&)> work;
    std::exception_ptr error;
    bool answered = false;
  };

  void perform(std::function<void(SQLite::Database&)> work);
  void serve();
  void commit_group(const std::vector<Write*>& group);
  void run_within_savepoint(Write& write);
  void checkpoint();

  SQLite::Database database_;
  std::mutex mutex_;
  std::condition_variable arrived_;
  std::condition_variable answered_;
  std::vector<Write*> waiting_;  // each lives on the stack of its caller until answered
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace rouleau::storage
