#include "service/queue/live_job.h"

#include <cstddef>

namespace rouleau::service {

namespace {

/// The membrane nodes stand at the head of a frame, cell by cell.
std::vector<storage::Outline> outlines_of(const Frame& frame, const std::vector<int>& nodes_per_cell) {
  std::vector<storage::Outline> outlines;
  std::ptrdiff_t first = 0;
  for (const int nodes : nodes_per_cell) {
    const std::ptrdiff_t last = first + nodes;
    if (static_cast<std::size_t>(last) > frame.x.size()) break;
    outlines.push_back({{frame.x.begin() + first, frame.x.begin() + last},
                        {frame.y.begin() + first, frame.y.begin() + last}});
    first = last;
  }
  return outlines;
}

}  // namespace

void LiveJob::begin(const RunHeader& header) {
  const std::lock_guard lock(mutex_);
  series_.columns = header.columns;
  series_.values.assign(header.columns.size(), {});
  nodes_per_cell_ = header.nodes_per_cell;
  walls_ = header.walls;
}

void LiveJob::series_row(std::span<const double> row) {
  const std::lock_guard lock(mutex_);
  for (std::size_t c = 0; c < series_.values.size() && c < row.size(); ++c)
    series_.values[c].push_back(row[c]);
}

void LiveJob::frame(const Frame& frame) {
  auto outlines = outlines_of(frame, nodes_per_cell_);
  const std::lock_guard lock(mutex_);
  outlines_.push_back({frame.time, std::move(outlines)});
  last_frame_ = frame;
}

void LiveJob::progress(const Progress& progress) {
  const std::lock_guard lock(mutex_);
  progress_ = progress;
}

storage::SeriesTable LiveJob::series() const {
  const std::lock_guard lock(mutex_);
  return series_;
}

std::vector<double> LiveJob::frame_times() const {
  const std::lock_guard lock(mutex_);
  std::vector<double> times;
  times.reserve(outlines_.size());
  for (const Outlines& frame : outlines_) times.push_back(frame.time);
  return times;
}

std::optional<std::vector<storage::Outline>> LiveJob::outlines(int k) const {
  const std::lock_guard lock(mutex_);
  if (k < 0 || static_cast<std::size_t>(k) >= outlines_.size()) return std::nullopt;
  return outlines_[static_cast<std::size_t>(k)].cells;
}

std::optional<Frame> LiveJob::last_frame() const {
  const std::lock_guard lock(mutex_);
  return last_frame_;
}

WallNodes LiveJob::walls() const {
  const std::lock_guard lock(mutex_);
  return walls_;
}

std::optional<Progress> LiveJob::progress() const {
  const std::lock_guard lock(mutex_);
  return progress_;
}

void LiveJob::stop(StopReason reason) {
  StopReason none = StopReason::none;
  if (stop_reason_.compare_exchange_strong(none, reason)) stop_.request_stop();
}

}  // namespace rouleau::service
