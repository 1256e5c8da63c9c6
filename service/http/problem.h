#pragma once

#include <exception>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "engine/case/case_error.h"

namespace rouleau::service {

/// A kind of error that clients may tell apart by its name. `type` is /problems/NAME (RFC 9457).
struct ProblemKind {
  std::string_view name;
  int status;
  std::string_view title;
  std::string_view meaning;  ///< what its page says: when it comes and what to do
};

namespace problems {
extern const ProblemKind bad_request;
extern const ProblemKind invalid_json;
extern const ProblemKind invalid_request;
extern const ProblemKind unknown_column;
extern const ProblemKind unauthorized;
extern const ProblemKind cross_origin;
extern const ProblemKind forbidden;
extern const ProblemKind not_found;
extern const ProblemKind method_not_allowed;
extern const ProblemKind request_timeout;
extern const ProblemKind not_finished;
extern const ProblemKind invalid_transition;
extern const ProblemKind idempotency_in_progress;
extern const ProblemKind expired;
extern const ProblemKind length_required;
extern const ProblemKind payload_too_large;
extern const ProblemKind uri_too_long;
extern const ProblemKind unsupported_media_type;
extern const ProblemKind range_not_satisfiable;
extern const ProblemKind unknown_host;
extern const ProblemKind invalid_case;
extern const ProblemKind sweep_too_large;
extern const ProblemKind idempotency_mismatch;
extern const ProblemKind too_many_requests;
extern const ProblemKind headers_too_large;
extern const ProblemKind internal;
extern const ProblemKind draining;
extern const ProblemKind too_many_connections;
extern const ProblemKind too_many_streams;
extern const ProblemKind queue_full;
extern const ProblemKind no_space;
extern const ProblemKind unavailable;
}  // namespace problems

/// Every kind there is, in order of status.
const std::vector<const ProblemKind*>& problem_kinds();

/// @return null if no kind has this name
const ProblemKind* find_problem_kind(std::string_view name);

/// The kind that stands for a bare HTTP status.
const ProblemKind& problem_kind_of_status(int status);

/// An error as a client sees it: thrown by handlers, written as application/problem+json.
class Problem : public std::exception {
 public:
  Problem(const ProblemKind& kind, std::string detail, std::vector<Fault> faults = {})
      : kind_(&kind), detail_(std::move(detail)), faults_(std::move(faults)) {}

  const ProblemKind& kind() const { return *kind_; }
  const std::string& detail() const { return detail_; }
  const std::vector<Fault>& faults() const { return faults_; }
  const char* what() const noexcept override { return detail_.c_str(); }

 private:
  const ProblemKind* kind_;
  std::string detail_;
  std::vector<Fault> faults_;
};

nlohmann::json to_json(const Problem& problem, std::string_view request_id);

/// Serialises for the wire: what is no valid UTF-8 is replaced, never thrown about.
std::string dump(const nlohmann::json& value);

}  // namespace rouleau::service
