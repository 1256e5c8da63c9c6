#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "storage/job.h"

namespace rouleau::service {

/// How far a client has come in the events of a job; the id of each event says it, and the client hands the
/// last one back in `Last-Event-ID`. Rows are counted over all attempts: each computes the same bits, as long
/// as it is the same engine's.
struct EventPlace {
  std::size_t rows = 0;                  ///< of the series
  std::optional<storage::TimeMs> ended;  ///< the end that it was told of

  bool operator==(const EventPlace&) const = default;
};

/// ROWS@VERSION, with an end ROWS@VERSION@TIME.
std::string to_event_id(const EventPlace& place);

/// @return the start where it is no id of ours, or of another engine's rows
EventPlace parse_event_id(std::string_view id);

}  // namespace rouleau::service
