#pragma once

#include <atomic>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <map>
#include <mutex>
#include <stop_token>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/plan/machine.h"
#include "service/sweep/sweep_points.h"

namespace rouleau::service {

/// Where the archive of a case lies in the folder of a sweep. Named by the case's hash, so that a sweep that
/// was changed finds the points that it still has.
std::filesystem::path sweep_archive(const std::filesystem::path& folder, const std::string& case_hash);

/// The points of a sweep, run in this process into one folder. Those whose result is there are not run
/// again, those that were interrupted go on from their checkpoint, and points with equal cases run once.
class LocalSweep {
 public:
  enum class State { waiting, succeeded, failed };

  struct Point {
    std::string case_hash;
    State state = State::waiting;
    bool reused = false;     ///< its result was there, or is another point's
    nlohmann::json summary;  ///< null while there is no result
    std::string error;       ///< why it failed
  };

  struct Standing {
    std::size_t points = 0, done = 0, failed = 0, reused = 0, running = 0;
    double fraction = 0;  ///< of what was not there at the start, by points
  };

  /// @param points  outlive this
  LocalSweep(const std::vector<SweepPoint>& points, std::filesystem::path folder, const Machine& machine);

  /// Runs what has no result, so many at a time. A point that fails does not keep others from running.
  void run(int workers, double checkpoint_interval, const std::stop_token& stop);

  /// From any thread.
  Standing standing() const;

  /// Once `run` has returned; in the order of the points.
  const std::vector<Point>& points() const { return states_; }

 private:
  class Watched;

  void take_results();
  void run_one(std::size_t k, double checkpoint_interval, const std::stop_token& stop);
  void settle(std::size_t k, State state, nlohmann::json summary, const std::string& error = {});

  const std::vector<SweepPoint>& given_;
  const std::filesystem::path folder_;
  const Machine machine_;
  std::vector<Point> states_;
  std::map<std::string, std::vector<std::size_t>> by_hash_;
  std::vector<std::size_t> to_run_;  ///< the first of those with the same case
  std::atomic<std::size_t> next_ = 0;

  mutable std::mutex mutex_;
  std::map<std::size_t, double> fractions_;  ///< of those that run
};

}  // namespace rouleau::service
