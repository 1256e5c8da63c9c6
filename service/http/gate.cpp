#include "service/http/gate.h"

#include <vector>

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

Admission Gate::admit(const RequestHead& head) const {
  Admission admission;
  try {
    decide(head, admission);
  } catch (const Problem& problem) {
    admission.refusal = problem;
  }
  return admission;
}

void Gate::decide(const RequestHead& head, Admission& admission) const {
  access_->check_host(head.header("Host"));
  const std::string path = path_of(head.target);
  if (path.starts_with("/v1/")) access_->check_token(head.header("Authorization"));
  admission.match = router_.find(head.method, path);
  const Router::Match& match = admission.match;
  if (match.allowed.empty()) throw Problem(problems::not_found, "nothing is at this address");
  if (match.route == nullptr) {
    admission.headers.emplace("Allow", join(match.allowed));
    throw Problem(problems::method_not_allowed, "this address takes " + join(match.allowed));
  }
  if (head.method != "GET" && head.method != "HEAD") {
    Access::check_origin(head.header("Origin"), head.header("Host"));
  }
  if ((head.content_length > 0 || match.route->body == Body::json) && !is_json(head.header("Content-Type"))) {
    throw Problem(problems::unsupported_media_type, "send the body as application/json");
  }
}

}  // namespace rouleau::service
