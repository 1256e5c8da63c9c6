#include "service/archive_use.h"

#include <utility>

namespace rouleau::service {

struct ArchiveUse::Shared {
  Clock::duration grace;
  std::function<Clock::time_point()> now;
  std::mutex mutex;
  std::map<std::string, Use> uses;
};

ArchiveUse::ArchiveUse(Clock::duration grace, std::function<Clock::time_point()> now)
    : shared_(std::make_shared<Shared>()) {
  shared_->grace = grace;
  shared_->now = std::move(now);
}

std::shared_ptr<const void> ArchiveUse::begin(const std::string& archive_id) const {
  {
    const std::lock_guard lock(shared_->mutex);
    ++shared_->uses[archive_id].readers;
  }
  return {nullptr, [shared = shared_, archive_id](const void*) {
            const std::lock_guard lock(shared->mutex);
            Use& use = shared->uses[archive_id];
            --use.readers;
            use.last = shared->now();
          }};
}

bool ArchiveUse::in_use(const std::string& archive_id) const {
  const std::lock_guard lock(shared_->mutex);
  const auto now = shared_->now();
  std::erase_if(shared_->uses, [&](const auto& entry) {
    return entry.second.readers == 0 && now - entry.second.last >= shared_->grace;
  });
  return shared_->uses.contains(archive_id);
}

}  // namespace rouleau::service
