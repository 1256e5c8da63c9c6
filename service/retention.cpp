#include "service/retention.h"

#include <exception>
#include <system_error>
#include <utility>

#include "service/http/problem.h"
#include "service/log.h"
#include "service/queue/job_files.h"

namespace rouleau::service {

namespace {

constexpr int jobs_at_a_time = 200;
// As long as the API promises that a replayed key gets its first answer.
constexpr storage::TimeMs keys_are_kept = storage::TimeMs{24} * 60 * 60 * 1000;

std::string megabytes(std::uint64_t bytes) {
  return std::to_string(bytes / 1'000'000) + " MB";
}

}  // namespace

Retention::Retention(storage::JobStore& store, ArchiveUse use, std::filesystem::path data,
                     RetentionRules rules, Forget forget, storage::Clock clock)
    : store_(store),
      use_(std::move(use)),
      data_(std::move(data)),
      rules_(rules),
      forget_(std::move(forget)),
      clock_(std::move(clock)) {}

Retention::~Retention() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  stopped_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void Retention::start() {
  thread_ = std::thread([this] { keep_running(); });
}

void Retention::keep_running() {
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    lock.unlock();
    try {
      run();
    } catch (const std::exception& error) {
      log::error("retention failed", {{"error", error.what()}});
    }
    lock.lock();
    stopped_.wait_for(lock, rules_.interval, [this] { return stopping_; });
  }
}

void Retention::run() {
  store_.forget_keys(clock_() - keys_are_kept);
  const int old = remove_the_old();
  const int in_the_way = make_room();
  if (old + in_the_way > 0) {
    log::info("old jobs removed",
              {{"beyond_their_age", std::to_string(old)}, {"to_make_room", std::to_string(in_the_way)}});
  }
}

int Retention::remove_the_old() {
  if (!rules_.keep) return 0;
  const auto keep = std::chrono::duration_cast<std::chrono::milliseconds>(*rules_.keep).count();
  const storage::TimeMs before = clock_() - keep;
  return remove_while([&](const storage::EndedJob& job) { return job.ended_at < before; });
}

int Retention::make_room() {
  const int beyond = remove_while([&](const storage::EndedJob&) { return !lack_of_allowance().empty(); });
  const int removed = beyond + remove_while([&](const storage::EndedJob&) { return !lack_of_disk().empty(); },
                                            [&](const storage::EndedJob& job) { return frees_room(job); });
  archives_full_ = !lack_of_room().empty();
  return removed;
}

bool Retention::frees_room(const storage::EndedJob& job) const {
  std::error_code gone;
  return job.archive_id &&
         std::filesystem::hard_link_count(archive_path(data_ / "archives", *job.archive_id), gone) == 1;
}

int Retention::remove_while(const Choice& is_to_go, const Choice& is_worth_it) {
  int removed = 0;
  std::optional<storage::EndedJob> last;
  while (true) {
    const auto jobs = store_.oldest_ended(jobs_at_a_time, last);
    for (const storage::EndedJob& job : jobs) {
      if (!is_to_go(job)) return removed;
      if (!is_worth_it(job) || (job.archive_id && use_.in_use(*job.archive_id))) continue;
      if (remove(job.id)) ++removed;
    }
    if (jobs.size() < static_cast<std::size_t>(jobs_at_a_time)) return removed;
    last = jobs.back();
  }
}

bool Retention::remove(const std::string& id) {
  try {
    const auto gone = store_.remove(id, storage::JobStore::Removal::expired);
    if (!gone) return false;
    forget_(id, gone->archive_id);
    log::debug("job removed", {{"job", id}});
    return true;
  } catch (const storage::InvalidTransition&) {
    return false;  // somebody retried it just now
  }
}

std::string Retention::lack_of_room() const {
  const std::string lack = lack_of_disk();
  return lack.empty() ? lack_of_allowance() : lack;
}

std::string Retention::lack_of_disk() const {
  if (rules_.least_free_bytes > 0) {
    std::error_code unknown;
    const auto space = std::filesystem::space(data_, unknown);
    if (!unknown && space.available < rules_.least_free_bytes) {
      return "the disk has " + megabytes(space.available) + " left, less than " +
             megabytes(rules_.least_free_bytes) + " (--min-free)";
    }
  }
  return {};
}

std::string Retention::lack_of_allowance() const {
  if (rules_.most_archive_bytes) {
    const auto bytes = static_cast<std::uint64_t>(store_.archive_bytes());
    if (bytes > *rules_.most_archive_bytes) {
      return "archives take " + megabytes(bytes) + ", more than " + megabytes(*rules_.most_archive_bytes) +
             " (--max-archive-space), and none may be removed";
    }
  }
  return {};
}

void Retention::check_room() {
  const bool look = archives_full_ || rules_.least_free_bytes > 0;
  if (!look) return;
  if (const std::string lack = lack_of_room(); !lack.empty()) throw Problem(problems::no_space, lack);
}

}  // namespace rouleau::service
