#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/simulation/output.h"
#include "storage/archive_reader.h"

namespace rouleau::service {

/// Why a run was asked to stop.
enum class StopReason { none, cancelled, paused, draining, lease_lost };

/// What is known of a job while it runs: its series, the outlines of every frame and the particles of the
/// last one. The run writes, any thread reads; readers get copies.
class LiveJob : public Output {
 public:
  LiveJob(std::string id, int attempt) : id_(std::move(id)), attempt_(attempt) {}

  const std::string& id() const { return id_; }
  int attempt() const { return attempt_; }

  /// What an attempt had before that is forgotten: it is delivered again.
  void begin(const RunHeader& header) override;
  void series_row(std::span<const double> row) override;
  void frame(const Frame& frame) override;
  void progress(const Progress& progress) override;

  /// What an earlier attempt had computed is there once this is.
  bool has_begun() const;
  storage::SeriesTable series() const;
  /// At most so many rows from `first` on.
  storage::SeriesTable series(std::size_t first, std::size_t most) const;
  std::vector<double> frame_times() const;                             ///< s
  std::optional<std::vector<storage::Outline>> outlines(int k) const;  ///< none: no such frame
  /// Of the last frame alone.
  std::optional<Frame> last_frame() const;
  WallNodes walls() const;
  std::optional<Progress> progress() const;

  /// The first reason given is kept.
  void stop(StopReason reason);
  StopReason stop_reason() const { return stop_reason_; }
  std::stop_token stop_token() const { return stop_.get_token(); }

 private:
  struct Outlines {
    double time = 0;
    std::vector<storage::Outline> cells;
  };

  const std::string id_;
  const int attempt_;
  std::stop_source stop_;
  std::atomic<StopReason> stop_reason_ = StopReason::none;

  mutable std::mutex mutex_;
  storage::SeriesTable series_;
  std::size_t cells_ = 0;
  WallNodes walls_;
  std::vector<MembraneField> membrane_fields_;
  std::vector<Outlines> outlines_;
  std::optional<Frame> last_frame_;
  std::optional<Progress> progress_;
};

}  // namespace rouleau::service
