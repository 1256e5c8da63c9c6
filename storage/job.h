#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rouleau::storage {

/// Milliseconds since 1970-01-01 UTC.
using TimeMs = std::int64_t;

enum class JobState { queued, running, paused, cancelling, succeeded, failed, cancelled };

inline constexpr std::array all_job_states{JobState::queued,     JobState::running,   JobState::paused,
                                           JobState::cancelling, JobState::succeeded, JobState::failed,
                                           JobState::cancelled};

/// The state's name in the API and in the database.
std::string_view to_string(JobState state);
std::optional<JobState> parse_job_state(std::string_view name);

/// Succeeded, failed or cancelled: it stays so unless somebody asks for it to be tried again.
bool has_ended(JobState state);

/// A job's place in a sweep.
struct SweepPlace {
  std::string sweep;  ///< its id
  int index = 0;      ///< from 0
};

/// What a client hands in. Texts are stored as they are; whoever submits has checked them.
struct NewJob {
  std::string name;
  std::string case_hash;      ///< hex, 64 digits: jobs with the same hash have the same result
  std::string case_given;     ///< the body as it came
  std::string case_resolved;  ///< JSON with every default filled in
  std::string plan;           ///< JSON
  std::string labels = "{}";  ///< JSON object of strings
  std::string lane;           ///< among equal priorities the lanes take turns
  int priority = 0;           ///< higher runs first
  bool fresh = false;         ///< run it even if its result is there
  std::optional<SweepPlace> place{};
};

/// A client's name for one request of its own: the same again is the same request.
struct IdempotencyKey {
  std::string caller;
  std::string key;
  std::string fingerprint;  ///< of the whole request, hex, 64 digits
};

/// A job as anyone may see it. The texts of its case are apart (`CaseText`), for they can be long.
struct Job {
  std::string id;  ///< UUIDv7; later jobs have greater ids
  JobState state = JobState::queued;
  std::string name;
  std::string case_hash;
  std::string labels;  ///< JSON object
  std::string lane;
  int priority = 0;
  bool fresh = false;
  std::optional<SweepPlace> place;
  std::optional<std::string> follows;    ///< the job with the same hash whose result it waits for
  std::optional<std::string> result_of;  ///< the job whose result it was given without running
  int attempt = 0;                       ///< claims so far; the fencing token of whoever holds it
  int setbacks = 0;                      ///< attempts that died since the last that left a checkpoint
  bool pause_requested = false;          ///< it runs, and stops at its next checkpoint
  TimeMs created_at = 0;
  std::optional<TimeMs> started_at;  ///< of the attempt that runs or ended it
  std::optional<TimeMs> ended_at;
  std::optional<TimeMs> not_before;          ///< a queued job is left alone until then
  std::optional<std::string> progress;       ///< JSON, last known
  std::string plan;                          ///< JSON
  std::optional<std::string> summary;        ///< JSON, once there is a result
  std::optional<std::string> error;          ///< JSON, once failed
  std::optional<std::string> archive_id;     ///< the job that wrote the archive, once there is a result
  std::optional<std::int64_t> archive_size;  ///< bytes
  std::optional<std::string> archive_sha256;
};

/// What came of handing in a job.
struct Submission {
  Job job;
  bool replayed = false;  ///< its key had been used for it before
};

/// What a run left behind.
struct JobResult {
  std::string summary;            ///< JSON
  std::int64_t archive_size = 0;  ///< bytes
  std::string archive_sha256;     ///< hex
};

struct CaseText {
  std::string given;
  std::string resolved;
};

struct ClaimedJob {
  Job job;
  CaseText text;
};

/// A key and value that a job's labels must hold.
using Label = std::pair<std::string, std::string>;

struct JobQuery {
  std::vector<JobState> states{};  ///< any of them; empty: every state
  std::vector<Label> labels{};     ///< all of them
  std::string sweep{};             ///< of this sweep; empty: of any or none
  int page_size = 50;              ///< 1 to 1000, clamped
  std::string page_token{};        ///< of the page before; empty: the newest
};

struct JobPage {
  std::vector<Job> jobs;                       ///< newest first
  std::optional<std::string> next_page_token;  ///< none on the last page
};

/// What a worker learns when it renews its lease.
enum class Lease { held, lost, cancel_requested, pause_requested };

struct QueueState {
  bool paused = false;                      ///< nothing is claimed
  std::map<JobState, std::int64_t> counts;  ///< one entry a state, zeros too
  std::optional<TimeMs> oldest_waiting;     ///< when the oldest queued job was submitted
};

/// A job that was removed.
struct Removed {
  std::optional<std::string> archive_id;  ///< the archive, if there is one, that no job has any more
};

/// A job that may be removed.
struct EndedJob {
  std::string id;
  TimeMs ended_at = 0;
  std::optional<std::string> archive_id;
};

}  // namespace rouleau::storage
