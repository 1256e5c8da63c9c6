#include "storage/sqlite/reader_pool.h"

namespace rouleau::storage {

ReaderPool::ReaderPool(const std::filesystem::path& file, int connections) {
  for (int i = 0; i < connections; ++i) idle_.emplace_back(open_for_reading(file));
}

Connection ReaderPool::take() {
  std::unique_lock lock(mutex_);
  returned_.wait(lock, [&] { return !idle_.empty(); });
  Connection database = std::move(idle_.back());
  idle_.pop_back();
  return database;
}

void ReaderPool::give_back(Connection database) {
  {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(database));
  }
  returned_.notify_one();
}

}  // namespace rouleau::storage
