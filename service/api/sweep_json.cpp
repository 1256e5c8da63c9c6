#include "service/api/sweep_json.h"

#include <cstdint>
#include <limits>

#include <nlohmann/json.hpp>

#include "service/sweep/sweep_points.h"
#include "service/time_text.h"

namespace rouleau::service {

nlohmann::json to_json(const storage::Sweep& sweep) {
  const auto given = nlohmann::json::parse(sweep.given);
  nlohmann::json counts;
  std::int64_t active = 0;
  for (const auto& [state, count] : sweep.counts) {
    counts[storage::to_string(state)] = count;
    if (!storage::has_ended(state)) active += count;
  }
  return {{"id", sweep.id},
          {"name", sweep.name},
          {"created_at", format_time(sweep.created_at)},
          {"labels", nlohmann::json::parse(sweep.labels)},
          {"priority", sweep.priority},
          {"mode", given.value("mode", "grid")},
          {"axes", given.at("axes")},
          {"counts", counts},
          {"active", active}};
}

nlohmann::json to_json(const storage::SweepJob& job, const SweepBody& body) {
  const auto choice = choice_at(body.axes, body.mode, static_cast<std::size_t>(job.index));
  return {{"id", job.id},
          {"index", job.index},
          {"state", storage::to_string(job.state)},
          {"values", values_at(body, choice)}};
}

SweepBody body_of(const storage::Sweep& sweep) {
  // As many points as it has: a server that takes fewer by now still knows those that it has.
  return read_sweep(nlohmann::json::parse(sweep.given), std::numeric_limits<int>::max(),
                    {"priority", "labels", "fresh"});
}

}  // namespace rouleau::service
