#include "service/http/gate.h"

#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

namespace rouleau::service {

namespace {

bool is_json(std::string_view content_type) {
  const std::string_view type = content_type.substr(0, content_type.find(';'));
  return equal_ignoring_case(type.substr(0, type.find_last_not_of(" \t") + 1), "application/json");
}

std::string join(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace

Admission Gate::admit(const RequestHead& head, const std::string& address) {
  Admission admission;
  try {
    decide(head, address, admission);
  } catch (const Problem& problem) {
    admission.refusal = problem;
  }
  return admission;
}

void Gate::count(const std::string& who, Admission& admission) {
  if (!limiter_.limits()) return;
  const auto& [per_second, burst] = limiter_.limit();
  const auto verdict = limiter_.take(who, RateLimiter::Clock::now());
  // As draft-ietf-httpapi-ratelimit-headers has them.
  admission.headers.emplace(
      "RateLimit-Policy",
      fmt::format("\"default\";q={:.0f};w={:.0f}", std::floor(burst), std::ceil(burst / per_second)));
  admission.headers.emplace("RateLimit", fmt::format("\"default\";r={:.0f};t={:.0f}",
                                                     std::floor(verdict.left), std::ceil(verdict.full_in_s)));
  if (verdict.admitted) return;
  admission.headers.emplace("Retry-After", fmt::format("{:.0f}", std::ceil(verdict.retry_in_s)));
  throw Problem(problems::too_many_requests, fmt::format("at most {:g} requests a second", per_second));
}

void Gate::decide(const RequestHead& head, const std::string& address, Admission& admission) {
  access_->check_host(head.header("Host"));
  const std::string path = path_of(head.target);
  std::optional<Caller> caller;
  const bool is_guarded = path.starts_with("/v1/");
  if (is_guarded) {
    caller = access_->identify(head.header("Authorization"));
    count(caller && !caller->name.empty() ? "token " + caller->name : "address " + address, admission);
    if (!caller) throw Problem(problems::unauthorized, "send a token of this server's token file");
    admission.caller = caller->name;
  }
  admission.match = router_.find(head.method, path);
  const Router::Match& match = admission.match;
  if (match.allowed.empty()) throw Problem(problems::not_found, "nothing is at this address");
  if (match.route == nullptr) {
    admission.headers.emplace("Allow", join(match.allowed));
    throw Problem(problems::method_not_allowed, "this address takes " + join(match.allowed));
  }
  if (is_guarded && caller->scope < match.route->scope) {
    throw Problem(problems::forbidden, "this needs a token with the scope " +
                                           std::string(to_string(match.route->scope)) + ", yours has " +
                                           std::string(to_string(caller->scope)));
  }
  if (head.method != "GET" && head.method != "HEAD") {
    Access::check_origin(head.header("Origin"), head.header("Host"));
  }
  if ((head.content_length > 0 || match.route->body == Body::json) && !is_json(head.header("Content-Type"))) {
    throw Problem(problems::unsupported_media_type, "send the body as application/json");
  }
}

}  // namespace rouleau::service
