#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "service/api/event_place.h"
#include "service/api/service.h"
#include "storage/archive_reader.h"

namespace rouleau::service {

/// What happens to a job, as server-sent events: `state` whenever it changes, `progress`, and `series` with
/// the rows as they are computed.
class JobEvents {
 public:
  /// At most so many rows are in one event, so that a long series is not in memory twice.
  static constexpr std::size_t most_rows = 1000;

  /// @param from  what the client has already
  JobEvents(Service& service, std::string id, const EventPlace& from);

  /// What is new since the last call; empty if nothing is.
  std::string next();

  /// The last event was the end of the job, or the job was removed.
  bool over() const { return over_; }

  /// Waits until the job may have changed its state, or the deadline.
  void wait(SignalBoard::Clock::time_point deadline);

 private:
  bool look();
  storage::SeriesTable new_rows();
  std::string state_event();
  std::string progress_event();
  std::string series_event(const storage::SeriesTable& rows);
  std::string event(const char* name, const std::string& data) const;

  Service& service_;
  const std::string id_;
  EventPlace place_;
  std::uint64_t seen_ = 0;  ///< the changes that `job_` is up to
  std::optional<storage::Job> job_;
  std::shared_ptr<LiveJob> live_;
  std::optional<storage::SeriesTable> stored_;  ///< of a job that does not run
  std::string last_state_;
  long last_steps_ = -1;
  bool columns_told_ = false;
  bool over_ = false;
};

}  // namespace rouleau::service
