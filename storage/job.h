#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rouleau::storage {

/// Milliseconds since 1970-01-01 UTC.
using TimeMs = std::int64_t;

enum class JobState { queued, running, cancelling, succeeded, failed, cancelled };

inline constexpr std::array all_job_states{JobState::queued,    JobState::running, JobState::cancelling,
                                           JobState::succeeded, JobState::failed,  JobState::cancelled};

/// The state's name in the API and in the database.
std::string_view to_string(JobState state);
std::optional<JobState> parse_job_state(std::string_view name);

/// Succeeded, failed or cancelled: nothing changes it any more.
bool has_ended(JobState state);

/// What a client hands in. Texts are stored as they are; whoever submits has checked them.
struct NewJob {
  std::string name;
  std::string case_given;     ///< the body as it came
  std::string case_resolved;  ///< JSON with every default filled in; its sha256 is the job's case_hash
  std::string plan;           ///< JSON
  std::string labels = "{}";  ///< JSON object of strings
  int priority = 0;           ///< higher runs first
};

/// A job as anyone may see it. The texts of its case are apart (`CaseText`), for they can be long.
struct Job {
  std::string id;  ///< UUIDv7; later jobs have greater ids
  JobState state = JobState::queued;
  std::string name;
  std::string case_hash;  ///< sha256 of the resolved case, hex
  std::string labels;     ///< JSON object
  int priority = 0;
  int attempt = 0;  ///< claims so far; the fencing token of whoever holds it
  TimeMs created_at = 0;
  std::optional<TimeMs> started_at;  ///< of the attempt that runs or ended it
  std::optional<TimeMs> ended_at;
  std::optional<TimeMs> not_before;          ///< a queued job is left alone until then
  std::optional<std::string> progress;       ///< JSON, last known
  std::string plan;                          ///< JSON
  std::optional<std::string> summary;        ///< JSON, once there is a result
  std::optional<std::string> error;          ///< JSON, once failed
  std::optional<std::int64_t> archive_size;  ///< bytes, once there is a result
  std::optional<std::string> archive_sha256;
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
  int page_size = 50;              ///< 1 to 1000, clamped
  std::string page_token{};        ///< of the page before; empty: the newest
};

struct JobPage {
  std::vector<Job> jobs;                       ///< newest first
  std::optional<std::string> next_page_token;  ///< none on the last page
};

/// What a worker learns when it renews its lease.
enum class Lease { held, lost, cancel_requested };

}  // namespace rouleau::storage
