#pragma once

#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "storage/job.h"

namespace rouleau::storage {

/// What a client hands in as one: jobs that are all stored or none.
struct NewSweep {
  std::string name;
  std::string labels = "{}";  ///< JSON object of strings
  std::string lane;
  int priority = 0;
  std::string given;  ///< JSON: the body as it came, to which the jobs belong by their index
};

struct Sweep {
  std::string id;  ///< UUIDv7; later sweeps have greater ids
  std::string name;
  std::string labels;
  int priority = 0;
  TimeMs created_at = 0;
  std::string given;
  std::map<JobState, std::int64_t> counts;  ///< of its jobs; one entry a state, zeros too

  std::int64_t jobs() const {
    return std::accumulate(counts.begin(), counts.end(), std::int64_t{0},
                           [](std::int64_t sum, const auto& entry) { return sum + entry.second; });
  }
};

struct SweepSubmission {
  Sweep sweep;
  bool replayed = false;  ///< its key had been used for it before
};

/// A job as its sweep sees it.
struct SweepJob {
  std::string id;
  int index = 0;
  JobState state = JobState::queued;
  std::string case_hash;
  std::optional<std::string> summary;  ///< JSON, if it was asked for and there is one
};

/// What is left to do for jobs that were cancelled together; others never began.
struct CancelledJobs {
  std::vector<std::string> running;       ///< their runs are to be stopped
  std::vector<std::string> had_progress;  ///< waited with a checkpoint
};

struct SweepPage {
  std::vector<Sweep> sweeps;                   ///< newest first
  std::optional<std::string> next_page_token;  ///< none on the last page
};

}  // namespace rouleau::storage
