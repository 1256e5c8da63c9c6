#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <future>
#include <mutex>
#include <optional>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include "storage/sqlite/connection.h"

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
    std::optional<std::invoke_result_t<Work&, Connection&>> result;
    perform([&](Connection& database) { result.emplace(work(database)); });
    return std::move(*result);
  }

 private:
  struct Write {
    std::function<void(Connection&)> work;
    std::exception_ptr error;
  };
  /// Writes that share a commit; all who wait for it are woken by one call.
  struct Group {
    std::vector<Write*> writes;  ///< their callers', who wait
    std::promise<void> committed;
    std::shared_future<void> answered = committed.get_future().share();
  };

  void perform(std::function<void(Connection&)> work);
  void serve();
  /// Waits for those whom the last commit answered to come back, if they are quick.
  void gather(std::unique_lock<std::mutex>& lock, std::size_t last_group);
  void commit_group(const std::vector<Write*>& group);
  void run_within_savepoint(Write& write);
  void checkpoint();

  Connection database_;
  std::mutex mutex_;
  std::condition_variable arrived_;
  Group waiting_;
  std::size_t wanted_ = 1;  ///< how many must wait for the writer to be woken
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace rouleau::storage
