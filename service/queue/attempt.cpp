#include "service/queue/attempt.h"

#include <optional>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "service/http/problem.h"
#include "service/log.h"
#include "service/queue/failure.h"
#include "service/queue/fan_out.h"
#include "service/queue/progress_json.h"

namespace rouleau::service {

namespace {

std::optional<std::string> progress_text(const LiveJob& job) {
  const auto progress = job.progress();
  if (!progress) return std::nullopt;
  return dump(to_json(*progress));
}

}  // namespace

std::filesystem::path archive_path(const std::filesystem::path& archives, std::string_view id) {
  return archives / (std::string(id) + ".h5");
}

void remove_unfinished_archives(const std::filesystem::path& archives) {
  for (const auto& entry : std::filesystem::directory_iterator(archives)) {
    if (entry.path().extension() == ".part") std::filesystem::remove(entry.path());
  }
}

Attempt::Attempt(storage::JobStore& store, LiveJobs& live, const std::filesystem::path& archives,
                 KnownMachine& machine, storage::ClaimedJob claimed)
    : store_(store),
      live_jobs_(live),
      claimed_(std::move(claimed)),
      live_(live.start(claimed_.job.id, claimed_.job.attempt)),
      archive_(archive_path(archives, claimed_.job.id)),
      machine_(machine) {}

void Attempt::run() {
  log::info("job started", {{"job", live_->id()}, {"attempt", std::to_string(live_->attempt())}});
  try {
    try {
      compute();
    } catch (const std::exception& error) {
      end_failed(error);
    }
  } catch (const std::exception& error) {
    // The store took no end. The lease runs out and the job goes back to the queue.
    log::error("job could not be ended", {{"job", live_->id()}, {"error", error.what()}});
  }
  live_jobs_.end(live_, !has_archive_);
}

void Attempt::compute() {
  if (live_->attempt() > most_attempts) {
    throw std::system_error(std::make_error_code(std::errc::state_not_recoverable),
                            "begun " + std::to_string(most_attempts) + " times and never ended");
  }
  const Case resolved = read_case(claimed_.text.resolved);
  storage::ArchiveWriter writer(archive_, claimed_.text.given);
  FanOut output({&writer, live_.get()});
  try {
    const RunSummary summary = run_case(resolved, output, live_->stop_token(), {}, machine_.known());
    if (summary.ending == Ending::stopped) {
      end_stopped();
    } else {
      publish(writer, summary);
    }
  } catch (const RunFailure& failure) {
    publish(writer, failure.summary(), &failure);
  }
}

void Attempt::publish(storage::ArchiveWriter& writer, const RunSummary& summary, const RunFailure* failure) {
  const auto lease = store_.renew(live_->id(), live_->attempt(), lease_time, progress_text(*live_));
  if (lease == storage::Lease::lost) {
    log::warn("lease lost, result dropped", {{"job", live_->id()}});
    return;
  }
  const storage::ArchiveFile file = writer.finish(summary);
  const storage::JobResult result{dump(to_json(summary)), static_cast<std::int64_t>(file.size), file.sha256};
  has_archive_ = failure == nullptr
                     ? store_.succeed(live_->id(), live_->attempt(), result)
                     : store_.fail(live_->id(), live_->attempt(), dump(failure_of(*failure).error), result);
  if (has_archive_) {
    if (failure != nullptr) return log_failed(*failure);
    log::info("job succeeded", {{"job", live_->id()},
                                {"wall_time_s", std::to_string(summary.wall_time)},
                                {"steps", std::to_string(summary.steps)}});
    return;
  }
  const auto job = store_.find(live_->id());
  const bool owned_by_another = job && job->archive_size;
  if (!owned_by_another) {
    std::filesystem::remove(archive_);
    std::filesystem::remove(storage::sidecar_path(archive_));
  }
  log::warn("attempt was not the job's own any more", {{"job", live_->id()}});
}

void Attempt::end_stopped() {
  switch (live_->stop_reason()) {
    case StopReason::cancelled:
      store_.mark_cancelled(live_->id(), live_->attempt());
      log::info("job cancelled", {{"job", live_->id()}});
      break;
    case StopReason::lease_lost:
      log::warn("lease lost, run given up", {{"job", live_->id()}});
      break;
    case StopReason::draining:
    case StopReason::none:
      store_.release(live_->id(), live_->attempt());
      log::info("job back in the queue", {{"job", live_->id()}});
      break;
  }
}

void Attempt::end_failed(const std::exception& error) {
  const Failure failure = failure_of(error);
  const bool again = failure.kind == Failure::Kind::infrastructure;
  if (const auto gap = retry_after(live_->attempt()); again && gap) {
    const auto wait = std::chrono::duration_cast<std::chrono::milliseconds>(*gap).count();
    store_.release(live_->id(), live_->attempt(), storage::system_clock_ms() + wait);
    log::warn("job will be tried again",
              {{"job", live_->id()}, {"in_s", std::to_string(gap->count())}, {"error", error.what()}});
    return;
  }
  store_.fail(live_->id(), live_->attempt(), dump(failure.error));
  log_failed(error);
}

void Attempt::log_failed(const std::exception& error) const {
  log::warn("job failed", {{"job", live_->id()},
                           {"kind", std::string(to_string(failure_of(error).kind))},
                           {"error", error.what()}});
}

}  // namespace rouleau::service
