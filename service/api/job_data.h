#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "service/api/service.h"
#include "storage/archive_reader.h"

namespace rouleau::service {

/// What a job has computed so far: from memory while it runs, from its archive once it has one or from the
/// unfinished one that it goes on from, and nothing where there is none of them.
class JobData {
 public:
  JobData(Service& service, const storage::Job& job);

  storage::SeriesTable series() const;
  std::vector<double> frame_times() const;  ///< s
  /// None: no such frame.
  std::optional<std::vector<storage::Outline>> outlines(int k) const;
  /// None: no such frame, or one whose particles are no longer in memory and not yet to be read.
  std::optional<Frame> frame(int k) const;
  /// Where the stress on the walls is sampled.
  WallNodes walls() const;
  bool is_live() const { return live_ != nullptr; }

 private:
  template <class Read>
  auto read(Read&& read) const -> decltype(read(std::declval<const storage::ArchiveReader&>()));

  std::shared_ptr<LiveJob> live_;
  std::optional<storage::ArchiveReader> archive_;
  bool is_finished_ = true;
};

}  // namespace rouleau::service
