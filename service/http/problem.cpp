#include "service/http/problem.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace rouleau::service {

namespace problems {

const ProblemKind bad_request{"bad-request", 400, "Bad request",
                              "The request is not well-formed HTTP, or a header of it makes no sense."};
const ProblemKind invalid_json{"invalid-json", 400, "The body is not JSON",
                               "The body could not be read as JSON: bad syntax, a key given twice, NaN, "
                               "invalid UTF-8, or nested too deep."};
const ProblemKind invalid_request{"invalid-request", 400, "The request is not valid",
                                  "A query parameter or a member of the body beside the case is unknown, of "
                                  "the wrong type or out of range. "
                                  "`errors` lists all of them."};
const ProblemKind unknown_column{"unknown-column", 400, "Unknown column",
                                 "`columns` names a column that this job's time series does not have."};
const ProblemKind unauthorized{
    "unauthorized", 401, "A token is needed",
    "This server was started with a token file: send `Authorization: Bearer TOKEN` with a token of it, as "
    "`rouleau token` makes them."};
const ProblemKind cross_origin{
    "cross-origin", 403, "Refused for pages of other sites",
    "A web page of another site tried to change something here. The `Origin` header must match `Host`."};
const ProblemKind forbidden{"forbidden", 403, "Not with this token",
                            "The token is known, but has not the scope that this takes: `read` to look, "
                            "`submit` to make and change jobs and sweeps, `admin` to control the queue. Ask "
                            "whoever keeps the token file for another."};
const ProblemKind not_found{"not-found", 404, "Not found",
                            "Nothing is at this address, or no job has this id."};
const ProblemKind method_not_allowed{"method-not-allowed", 405, "Method not allowed",
                                     "This address does not take this method; `Allow` lists those it takes."};
const ProblemKind request_timeout{"request-timeout", 408, "The request took too long",
                                  "The head or the body of the request did not arrive in time."};
const ProblemKind not_finished{"not-finished", 409, "The job has no archive",
                               "The archive is there once the job has succeeded, or failed because its run "
                               "went unstable. Wait for it with "
                               "`GET /v1/jobs/{id}?wait=20s`."};
const ProblemKind invalid_transition{
    "invalid-transition", 409, "Not possible in this state",
    "The state that the job is in does not allow this; `detail` says what it "
    "does allow."};
const ProblemKind idempotency_in_progress{
    "idempotency-in-progress", 409, "The same request is being worked on",
    "Another request with this `Idempotency-Key` has not been answered yet. Wait and send it again."};
const ProblemKind expired{
    "expired", 410, "The job was removed",
    "The job had ended and was removed to make room for others. Submit its case again."};
const ProblemKind length_required{
    "length-required", 411, "Content-Length is needed",
    "Bodies are taken with a Content-Length only; chunked transfer encoding is not."};
const ProblemKind payload_too_large{"payload-too-large", 413, "The body is too large",
                                    "The body is larger than any case needs to be."};
const ProblemKind uri_too_long{"uri-too-long", 414, "The address is too long",
                               "The request's target is longer than any address here."};
const ProblemKind unsupported_media_type{
    "unsupported-media-type", 415, "Only plain JSON bodies",
    "Send the body as `Content-Type: application/json`, not compressed."};
const ProblemKind range_not_satisfiable{
    "range-not-satisfiable", 416, "No such range",
    "The range begins past the end of the file; `Content-Range` tells its size."};
const ProblemKind unknown_host{"unknown-host", 421, "Not for this host",
                               "A server on the loopback address answers only for localhost, 127.0.0.1 and "
                               "[::1], so that no foreign web "
                               "page reaches it through a name of its own."};
const ProblemKind invalid_case{
    "invalid-case", 422, "The case cannot be run",
    "The case has faults; `errors` lists all of them, each with its JSON Pointer."};
const ProblemKind sweep_too_large{"sweep-too-large", 422, "The sweep has too many points",
                                  "The axes span more points than this server takes in one sweep, or these "
                                  "together are too long. Submit it in parts."};
const ProblemKind idempotency_mismatch{
    "idempotency-mismatch", 422, "The key stands for another request",
    "This `Idempotency-Key` was used before with another body or at another address. Take a new key."};
const ProblemKind too_many_requests{
    "too-many-requests", 429, "Too many requests",
    "More requests came from this token, or from this address, than are taken. Try again after "
    "`Retry-After` seconds; `RateLimit-Policy` and `RateLimit` tell how many may come and how many are "
    "left."};
const ProblemKind headers_too_large{"headers-too-large", 431, "Too many or too large headers",
                                    "The request's headers are more, or longer, than are read here."};
const ProblemKind internal{"internal", 500, "Something went wrong here",
                           "A fault of the server; its log tells more under the request id."};
const ProblemKind draining{"draining", 503, "The server is shutting down",
                           "The server takes no new jobs now. Try again after `Retry-After` seconds."};
const ProblemKind too_many_connections{
    "too-many-connections", 503, "Too many connections",
    "The server, or one address, has as many connections as it takes. Close those that are idle, and try "
    "again after `Retry-After` seconds."};
const ProblemKind queue_full{"queue-full", 503, "Too many jobs wait",
                             "The queue has no room. Try again after `Retry-After` seconds, or let whoever "
                             "runs the server raise `--max-queued`."};
const ProblemKind too_many_streams{
    "too-many-streams", 503, "Too many event streams",
    "As many event streams are open as the server allows (`--max-streams`). Close one, try again after "
    "`Retry-After` seconds, or ask for the job itself with `?wait=20s`."};
const ProblemKind no_space{
    "no-space", 503, "No room for results",
    "The disk or the room for archives is full, and nothing may be removed. Fetch and delete "
    "what has ended, or try again later."};
const ProblemKind unavailable{"unavailable", 503, "Nothing can be stored now",
                              "The disk is full or refuses; the job was not accepted. Try again later."};

}  // namespace problems

const std::vector<const ProblemKind*>& problem_kinds() {
  using namespace problems;
  static const std::vector<const ProblemKind*> kinds{
      &bad_request,
      &invalid_json,
      &invalid_request,
      &unknown_column,
      &unauthorized,
      &cross_origin,
      &forbidden,
      &not_found,
      &method_not_allowed,
      &request_timeout,
      &not_finished,
      &invalid_transition,
      &idempotency_in_progress,
      &expired,
      &length_required,
      &payload_too_large,
      &uri_too_long,
      &unsupported_media_type,
      &range_not_satisfiable,
      &unknown_host,
      &invalid_case,
      &sweep_too_large,
      &idempotency_mismatch,
      &too_many_requests,
      &headers_too_large,
      &internal,
      &draining,
      &too_many_connections,
      &queue_full,
      &too_many_streams,
      &no_space,
      &unavailable,
  };
  return kinds;
}

const ProblemKind* find_problem_kind(std::string_view name) {
  const auto& kinds = problem_kinds();
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [&](const ProblemKind* kind) { return kind->name == name; });
  return found == kinds.end() ? nullptr : *found;
}

const ProblemKind& problem_kind_of_status(int status) {
  for (const ProblemKind* kind : problem_kinds()) {
    if (kind->status == status) return *kind;
  }
  return status >= 500 ? problems::internal : problems::bad_request;
}

nlohmann::json to_json(const Problem& problem, std::string_view request_id) {
  nlohmann::json body{{"type", "/problems/" + std::string(problem.kind().name)},
                      {"title", problem.kind().title},
                      {"status", problem.kind().status},
                      {"detail", problem.detail()},
                      {"request_id", request_id}};
  if (!problem.faults().empty()) {
    auto& errors = body["errors"] = nlohmann::json::array();
    for (const Fault& fault : problem.faults()) {
      errors.push_back({{"pointer", fault.pointer}, {"message", fault.message}});
    }
  }
  return body;
}

std::string dump(const nlohmann::json& value) {
  return value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace rouleau::service
