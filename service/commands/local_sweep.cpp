#include "service/commands/local_sweep.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <thread>
#include <utility>

#include "engine/case/case_json.h"
#include "engine/error/checkpoint_error.h"
#include "engine/simulation/run.h"
#include "service/case_hash.h"
#include "service/commands/resumable_run.h"
#include "storage/archive_reader.h"
#include "storage/interrupted_run.h"

namespace rouleau::service {

namespace {

nlohmann::json without_name(nlohmann::json resolved) {
  resolved.erase("name");
  return resolved;
}

/// The summary of this very case's run by this version, if it came to its end; null otherwise.
nlohmann::json result_of(const std::filesystem::path& archive, const Case& resolved) {
  if (!std::filesystem::exists(archive)) return nullptr;
  try {
    const storage::ArchiveReader reader(archive);
    if (reader.version() != engine_version()) return nullptr;
    if (without_name(reader.case_resolved()) != without_name(to_json(resolved))) return nullptr;
    nlohmann::json summary = reader.summary();
    return summary.is_object() && summary.value("ending", "stopped") != "stopped" ? summary : nullptr;
  } catch (const storage::ArchiveError&) {
    return nullptr;
  }
}

bool went_unstable(const nlohmann::json& summary) {
  return summary.value("ending", "") == "failed";
}

/// A checkpoint that cannot be gone on from is another run's; then the point begins anew.
std::optional<storage::InterruptedRun> interrupted_run(const std::filesystem::path& archive,
                                                       const Case& resolved) {
  try {
    return storage::find_interrupted(archive, resolved);
  } catch (const CheckpointError&) {
    return std::nullopt;
  }
}

}  // namespace

std::filesystem::path sweep_archive(const std::filesystem::path& folder, const std::string& case_hash) {
  return folder / (case_hash.substr(0, 16) + ".h5");
}

/// Notes how far a point is.
class LocalSweep::Watched : public Output {
 public:
  Watched(LocalSweep& sweep, std::size_t point) : sweep_(sweep), point_(point) { note(0); }
  ~Watched() override {
    const std::lock_guard lock(sweep_.mutex_);
    sweep_.fractions_.erase(point_);
  }
  Watched(const Watched&) = delete;
  Watched& operator=(const Watched&) = delete;

  void progress(const Progress& progress) override { note(progress.fraction); }

 private:
  void note(double fraction) {
    const std::lock_guard lock(sweep_.mutex_);
    sweep_.fractions_[point_] = fraction;
  }

  LocalSweep& sweep_;
  const std::size_t point_;
};

LocalSweep::LocalSweep(const std::vector<SweepPoint>& points, std::filesystem::path folder,
                       const Machine& machine)
    : given_(points), folder_(std::move(folder)), machine_(machine), states_(points.size()) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    states_[k].case_hash = case_hash(points[k].resolved);
    by_hash_[states_[k].case_hash].push_back(k);
  }
  take_results();
}

void LocalSweep::take_results() {
  for (std::size_t k = 0; k < given_.size(); ++k) {
    if (by_hash_.at(states_[k].case_hash).front() != k) continue;
    nlohmann::json summary = result_of(sweep_archive(folder_, states_[k].case_hash), given_[k].resolved);
    if (summary.is_null()) {
      to_run_.push_back(k);
      continue;
    }
    const std::string reason = summary.value("reason", "");
    const State state = went_unstable(summary) ? State::failed : State::succeeded;
    settle(k, state, std::move(summary), state == State::failed ? reason : "");
    states_[k].reused = true;
  }
}

void LocalSweep::run(int workers, double checkpoint_interval, const std::stop_token& stop) {
  const auto work = [&] {
    for (std::size_t turn = next_++; turn < to_run_.size() && !stop.stop_requested(); turn = next_++) {
      run_one(to_run_[turn], checkpoint_interval, stop);
    }
  };
  std::vector<std::jthread> threads;
  const std::size_t useful = std::min(static_cast<std::size_t>(workers), to_run_.size());
  for (std::size_t i = 0; i < useful; ++i) threads.emplace_back(work);
}

void LocalSweep::run_one(std::size_t k, double checkpoint_interval, const std::stop_token& stop) {
  const SweepPoint& point = given_[k];
  const auto archive = sweep_archive(folder_, states_[k].case_hash);
  try {
    const RunEnd end = [&] {
      Watched progress(*this, k);
      return run_resumable({archive, point.given, point.resolved, checkpoint_interval, machine_},
                           interrupted_run(archive, point.resolved), progress, stop);
    }();
    if (end.summary.ending == Ending::stopped) return;
    settle(k, end.failure ? State::failed : State::succeeded, to_json(end.summary),
           end.failure ? end.failure->what() : "");
  } catch (const std::exception& error) {
    settle(k, State::failed, nullptr, error.what());
  }
}

void LocalSweep::settle(std::size_t k, State state, nlohmann::json summary, const std::string& error) {
  const std::lock_guard lock(mutex_);
  for (const std::size_t same : by_hash_.at(states_[k].case_hash)) {
    states_[same] = {states_[same].case_hash, state, same != k, summary, error};
  }
}

LocalSweep::Standing LocalSweep::standing() const {
  const std::lock_guard lock(mutex_);
  Standing standing;
  standing.points = states_.size();
  for (const Point& point : states_) {
    standing.done += point.state != State::waiting ? 1 : 0;
    standing.failed += point.state == State::failed ? 1 : 0;
    standing.reused += point.reused ? 1 : 0;
  }
  standing.running = fractions_.size();
  double ran = 0;
  for (const std::size_t k : to_run_) ran += states_[k].state != State::waiting ? 1 : 0;
  for (const auto& [point, fraction] : fractions_) ran += fraction;
  standing.fraction = to_run_.empty() ? 1 : ran / static_cast<double>(to_run_.size());
  return standing;
}

}  // namespace rouleau::service
