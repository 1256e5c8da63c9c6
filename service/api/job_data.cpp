#include "service/api/job_data.h"

namespace rouleau::service {

JobData::JobData(Service& service, const storage::Job& job) {
  if (job.archive_size) {
    archive_.emplace(archive_of(service, job));
  } else {
    live_ = service.queue.live().find(job.id);
  }
}

storage::SeriesTable JobData::series() const {
  if (live_) return live_->series();
  return archive_ ? archive_->series() : storage::SeriesTable{};
}

std::vector<double> JobData::frame_times() const {
  if (live_) return live_->frame_times();
  return archive_ ? archive_->frame_times() : std::vector<double>{};
}

std::optional<std::vector<storage::Outline>> JobData::outlines(int k) const {
  if (live_) return live_->outlines(k);
  if (!archive_ || k < 0 || k >= archive_->frame_count()) return std::nullopt;
  return archive_->outlines(k);
}

std::optional<Frame> JobData::frame(int k) const {
  if (live_) {
    const auto times = live_->frame_times();
    auto last = live_->last_frame();
    if (last && k >= 0 && static_cast<std::size_t>(k) < times.size() &&
        last->time == times[static_cast<std::size_t>(k)]) {
      return last;
    }
    return std::nullopt;
  }
  if (!archive_ || k < 0 || k >= archive_->frame_count()) return std::nullopt;
  return archive_->frame(k);
}

WallNodes JobData::walls() const {
  if (live_) return live_->walls();
  return archive_ ? archive_->walls() : WallNodes{};
}

}  // namespace rouleau::service
