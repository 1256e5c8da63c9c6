#include "storage/job.h"

#include <array>

#include "storage/store_error.h"

namespace rouleau::storage {

namespace {

constexpr std::array<std::string_view, all_job_states.size()> names{
    "queued", "running", "paused", "cancelling", "succeeded", "failed", "cancelled"};

}  // namespace

std::string_view to_string(JobState state) {
  return names[static_cast<std::size_t>(state)];
}

std::optional<JobState> parse_job_state(std::string_view name) {
  for (const JobState state : all_job_states) {
    if (to_string(state) == name) return state;
  }
  return std::nullopt;
}

bool has_ended(JobState state) {
  return state == JobState::succeeded || state == JobState::failed || state == JobState::cancelled;
}

InvalidTransition::InvalidTransition(JobState state)
    : std::runtime_error("the job is " + std::string(to_string(state))), state_(state) {}

}  // namespace rouleau::storage
