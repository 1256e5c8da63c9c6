#include "service/queue/live_job.h"

#include <algorithm>

namespace rouleau::service {

namespace {

/// The membrane nodes stand at the head of a frame, cell by cell.
std::vector<storage::Outline> outlines_of(const Frame& frame, std::size_t cells,
                                          const std::vector<MembraneField>& fields) {
  std::vector<storage::Outline> outlines(cells);
  for (std::size_t i = 0; i < frame.x.size() && frame.kind[i] == ParticleKind::membrane; ++i) {
    storage::Outline& outline = outlines.at(static_cast<std::size_t>(frame.cell[i]));
    outline.x.push_back(frame.x[i]);
    outline.y.push_back(frame.y[i]);
    for (std::size_t f = 0; f < fields.size(); ++f) {
      outline.fields[fields[f].name].push_back(frame.membrane_fields.at(f).at(i));
    }
  }
  return outlines;
}

}  // namespace

void LiveJob::begin(const RunHeader& header) {
  const std::lock_guard lock(mutex_);
  series_.columns = header.columns;
  series_.values.assign(header.columns.size(), {});
  cells_ = header.nodes_per_cell.size();
  walls_ = header.walls;
  membrane_fields_ = header.membrane_fields;
  outlines_.clear();
  last_frame_.reset();
}

void LiveJob::series_row(std::span<const double> row) {
  const std::lock_guard lock(mutex_);
  for (std::size_t c = 0; c < series_.values.size() && c < row.size(); ++c)
    series_.values[c].push_back(row[c]);
}

void LiveJob::frame(const Frame& frame) {
  auto outlines = outlines_of(frame, cells_, membrane_fields_);
  const std::lock_guard lock(mutex_);
  outlines_.push_back({frame.time, std::move(outlines)});
  last_frame_ = frame;
}

void LiveJob::progress(const Progress& progress) {
  const std::lock_guard lock(mutex_);
  progress_ = progress;
}

bool LiveJob::has_begun() const {
  const std::lock_guard lock(mutex_);
  return !series_.columns.empty();
}

storage::SeriesTable LiveJob::series() const {
  const std::lock_guard lock(mutex_);
  return series_;
}

storage::SeriesTable LiveJob::series(std::size_t first, std::size_t most) const {
  const std::lock_guard lock(mutex_);
  storage::SeriesTable part{series_.columns, {}};
  for (const auto& values : series_.values) {
    const std::size_t begin = std::min(first, values.size());
    const std::size_t end = begin + std::min(most, values.size() - begin);
    part.values.emplace_back(values.begin() + static_cast<std::ptrdiff_t>(begin),
                             values.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return part;
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
