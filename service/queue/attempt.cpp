#include "service/queue/attempt.h"

#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "engine/error/checkpoint_error.h"
#include "service/http/problem.h"
#include "service/log.h"
#include "service/queue/attempt_notes.h"
#include "service/queue/failure.h"
#include "service/queue/fan_out.h"
#include "service/queue/finished_archive.h"
#include "service/queue/progress_json.h"

namespace rouleau::service {

namespace {

std::optional<std::string> progress_text(const LiveJob& job) {
  const auto progress = job.progress();
  if (!progress) return std::nullopt;
  return dump(to_json(*progress));
}

}  // namespace

Attempt::Attempt(Workplace& place, storage::ClaimedJob claimed)
    : place_(place),
      claimed_(std::move(claimed)),
      live_(place.live.start(job().id, job().attempt)),
      archive_(archive_path(place.archives, job().id)) {}

void Attempt::run() {
  log::info("job started", {{"job", job().id}, {"attempt", std::to_string(job().attempt)}});
  place_.logs.note(job(), "started", {{"attempt", std::to_string(job().attempt)}});
  try {
    try {
      compute();
    } catch (const std::exception& error) {
      writer_.reset();
      end_failed(error);
    }
  } catch (const std::exception& error) {
    // The store took no end. The lease runs out and the job goes back to the queue.
    log::error("job could not be ended", {{"job", job().id}, {"error", error.what()}});
  }
  writer_.reset();
  place_.live.end(live_, !has_archive_);
}

void Attempt::compute() {
  if (job().setbacks >= most_setbacks) {
    throw std::system_error(
        std::make_error_code(std::errc::state_not_recoverable),
        "begun " + std::to_string(most_setbacks) + " times and never came to a checkpoint");
  }
  const Case resolved = read_case(claimed_.text.resolved);
  if (const auto result = finished_result(archive_, resolved)) {
    place_.logs.note(job(), "had ended already");
    return record(*result);
  }
  try {
    const RunSummary summary = run_on(resolved);
    if (summary.ending == Ending::stopped) {
      end_stopped();
    } else {
      publish(summary);
    }
  } catch (const RunFailure& failure) {
    publish(failure.summary(), &failure);
  }
}

RunSummary Attempt::run_on(const Case& resolved) {
  if (const auto interrupted = find_interrupted(resolved)) {
    place_.logs.note(job(), "goes on",
                     {{"step", std::to_string(interrupted->head.steps)},
                      {"simulated_time", fmt::format("{:.6g}", interrupted->head.simulated_time)}});
    try {
      return run_from(resolved, &*interrupted);
    } catch (const CheckpointError& error) {
      begin_anew(error.what());
    } catch (const storage::ArchiveError& error) {
      if (error.kind() != storage::ArchiveError::Kind::format) throw;
      begin_anew(error.what());
    }
  }
  return run_from(resolved, nullptr);
}

std::optional<storage::InterruptedRun> Attempt::find_interrupted(const Case& resolved) {
  try {
    if (job().setbacks >= setbacks_until_anew) {
      throw CheckpointError("the last " + std::to_string(job().setbacks) + " attempts died");
    }
    if (auto interrupted = storage::find_interrupted(archive_, resolved)) return interrupted;
    remove_unfinished(place_.archives, job().id);
  } catch (const CheckpointError& error) {
    begin_anew(error.what());
  }
  return std::nullopt;
}

void Attempt::begin_anew(const std::string& why) {
  writer_.reset();
  remove_unfinished(place_.archives, job().id);
  place_.logs.note(job(), "begins anew", {{"because", why}});
  log::warn("checkpoint not used", {{"job", job().id}, {"because", why}});
}

RunSummary Attempt::run_from(const Case& resolved, const storage::InterruptedRun* interrupted) {
  writer_.emplace(archive_, claimed_.text.given);
  storage::CheckpointKeeper keeper(archive_);
  AttemptNotes notes(place_.store, place_.logs, job(), resolved);
  FanOut seen({&*writer_, live_.get()});
  std::vector<Output*> outputs{&seen, &keeper, &notes};
  std::optional<storage::ResumedOutput> resumed;
  if (interrupted) outputs.push_back(&resumed.emplace(*interrupted, seen));
  FanOut output(outputs);
  return run_case(resolved, output, live_->stop_token(),
                  {interrupted ? &interrupted->checkpoint : nullptr, place_.checkpoint_interval.count()},
                  place_.machine.known());
}

void Attempt::publish(const RunSummary& summary, const RunFailure* failure) {
  const auto lease = place_.store.renew(job().id, job().attempt, lease_time, progress_text(*live_));
  if (lease == storage::Lease::lost) {
    log::warn("lease lost, result dropped", {{"job", job().id}});
    return;
  }
  const storage::ArchiveFile file = writer_->finish(summary);
  note_summary(place_.logs, job(), summary);
  record({dump(to_json(summary)), static_cast<std::int64_t>(file.size), file.sha256}, failure);
}

void Attempt::record(const storage::JobResult& result, const RunFailure* failure) {
  has_archive_ = failure == nullptr
                     ? place_.store.succeed(job().id, job().attempt, result)
                     : place_.store.fail(job().id, job().attempt, dump(failure_of(*failure).error), result);
  if (has_archive_) {
    remove_unfinished(place_.archives, job().id);
    if (failure != nullptr) return note_failed(*failure);
    log::info("job succeeded", {{"job", job().id}});
    place_.logs.note_end(job(), "succeeded", {{"archive_bytes", std::to_string(result.archive_size)}});
    return;
  }
  const auto now = place_.store.find(job().id);
  const bool owned_by_another = now && now->archive_size;
  if (!owned_by_another) remove_archive(place_.archives, job().id);
  log::warn("attempt was not the job's own any more", {{"job", job().id}});
}

void Attempt::end_stopped() {
  writer_.reset();
  if (live_->stop_reason() == StopReason::lease_lost) {
    log::warn("lease lost, run given up", {{"job", job().id}});
    return;
  }
  place_.store.renew(job().id, job().attempt, lease_time, progress_text(*live_));
  if (!place_.store.release(job().id, job().attempt)) return;
  const auto now = place_.store.find(job().id);
  if (!now) return;
  switch (now->state) {
    case storage::JobState::cancelled:
      remove_unfinished(place_.archives, job().id);
      log::info("job cancelled", {{"job", job().id}});
      place_.logs.note_end(job(), "cancelled");
      break;
    case storage::JobState::paused:
      log::info("job paused", {{"job", job().id}});
      place_.logs.note(job(), "paused");
      break;
    default:
      log::info("job back in the queue", {{"job", job().id}});
      place_.logs.note(job(), "back in the queue");
  }
}

void Attempt::end_failed(const std::exception& error) {
  const Failure failure = failure_of(error);
  const bool again = failure.kind == Failure::Kind::infrastructure;
  // Read anew: they are none once this attempt has left a checkpoint.
  const auto now = place_.store.find(job().id);
  if (const auto gap = retry_after(now ? now->setbacks + 1 : 1); again && gap) {
    const auto wait = std::chrono::duration_cast<std::chrono::milliseconds>(*gap).count();
    place_.store.release(job().id, job().attempt, storage::system_clock_ms() + wait);
    log::warn("job will be tried again",
              {{"job", job().id}, {"in_s", std::to_string(gap->count())}, {"error", error.what()}});
    place_.logs.note(job(), "will be tried again",
                     {{"in_s", std::to_string(gap->count())}, {"error", error.what()}});
    return;
  }
  // Once the disk has room again, a job that failed for want of it can be told to go on.
  if (!again) remove_unfinished(place_.archives, job().id);
  place_.store.fail(job().id, job().attempt, dump(failure.error));
  note_failed(error);
}

void Attempt::note_failed(const std::exception& error) {
  const std::string kind(to_string(failure_of(error).kind));
  log::warn("job failed", {{"job", job().id}, {"kind", kind}, {"error", error.what()}});
  place_.logs.note_end(job(), "failed", {{"kind", kind}, {"error", error.what()}});
}

}  // namespace rouleau::service
