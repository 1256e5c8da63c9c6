#include "service/api/job_data.h"

#include "service/queue/job_files.h"

namespace rouleau::service {

JobData::JobData(Service& service, const storage::Job& job) {
  if (job.archive_size) {
    archive_.emplace(archive_of(service, job));
    return;
  }
  live_ = service.queue.live().find(job.id);
  if ((live_ && live_->has_begun()) || storage::has_ended(job.state)) return;
  // It waits with what it has computed.
  const auto unfinished = unfinished_archive(service.queue.archives(), job.id);
  if (unfinished.empty()) return;
  try {
    archive_.emplace(unfinished);
  } catch (const storage::ArchiveError&) {
    return;  // a worker has just taken it, or it is torn
  }
  live_.reset();
  is_finished_ = false;
}

/// Of an archive that is not finished the end may be torn, or a worker may just take it: then there is
/// nothing.
template <class Read>
auto JobData::read(Read&& read) const -> decltype(read(std::declval<const storage::ArchiveReader&>())) {
  if (!archive_) return {};
  try {
    return read(*archive_);
  } catch (const storage::ArchiveError&) {
    if (is_finished_) throw;
    return {};
  }
}

storage::SeriesTable JobData::series() const {
  if (live_) return live_->series();
  return read([](const storage::ArchiveReader& archive) { return archive.series(); });
}

std::vector<double> JobData::frame_times() const {
  if (live_) return live_->frame_times();
  return read([](const storage::ArchiveReader& archive) { return archive.frame_times(); });
}

std::optional<std::vector<storage::Outline>> JobData::outlines(int k) const {
  if (live_) return live_->outlines(k);
  return read([k](const storage::ArchiveReader& archive) -> std::optional<std::vector<storage::Outline>> {
    if (k < 0 || k >= archive.frame_count()) return std::nullopt;
    return archive.outlines(k);
  });
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
  return read([k](const storage::ArchiveReader& archive) -> std::optional<Frame> {
    if (k < 0 || k >= archive.frame_count()) return std::nullopt;
    return archive.frame(k);
  });
}

WallNodes JobData::walls() const {
  if (live_) return live_->walls();
  return read([](const storage::ArchiveReader& archive) { return archive.walls(); });
}

}  // namespace rouleau::service
