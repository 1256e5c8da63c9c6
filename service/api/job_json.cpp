#include "service/api/job_json.h"

#include <nlohmann/json.hpp>

#include "service/queue/progress_json.h"
#include "service/time_text.h"

namespace rouleau::service {

namespace {

nlohmann::json time_or_null(const std::optional<storage::TimeMs>& time) {
  return time ? nlohmann::json(format_time(*time)) : nlohmann::json();
}

nlohmann::json parsed_or_null(const std::optional<std::string>& text) {
  return text ? nlohmann::json::parse(*text) : nlohmann::json();
}

nlohmann::json progress_of(const storage::Job& job, const LiveJobs& live) {
  if (job.state == storage::JobState::running || job.state == storage::JobState::cancelling) {
    const auto running = live.find(job.id);
    if (const auto progress = running ? running->progress() : std::nullopt) return to_json(*progress);
  }
  return parsed_or_null(job.progress);
}

}  // namespace

nlohmann::json to_json(const storage::Job& job, const LiveJobs& live) {
  return {{"id", job.id},
          {"state", storage::to_string(job.state)},
          {"name", job.name},
          {"case_hash", job.case_hash},
          {"labels", nlohmann::json::parse(job.labels)},
          {"priority", job.priority},
          {"lane", job.lane},
          {"sweep", job.place ? nlohmann::json(job.place->sweep) : nlohmann::json()},
          {"sweep_index", job.place ? nlohmann::json(job.place->index) : nlohmann::json()},
          {"result_of", job.result_of ? nlohmann::json(*job.result_of) : nlohmann::json()},
          {"pause_requested", job.pause_requested},
          {"attempt", job.attempt},
          {"created_at", format_time(job.created_at)},
          {"started_at", time_or_null(job.started_at)},
          {"ended_at", time_or_null(job.ended_at)},
          {"progress", progress_of(job, live)},
          {"summary", parsed_or_null(job.summary)},
          {"error", parsed_or_null(job.error)}};
}

}  // namespace rouleau::service
