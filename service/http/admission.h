#pragma once

#include <optional>
#include <string>

#include <httplib.h>

#include "service/http/problem.h"
#include "service/http/router.h"

namespace rouleau::service {

/// What is decided about a request from its head alone, before any of its body is waited for.
struct Admission {
  Router::Match match;  ///< with a route unless the request is refused
  std::string caller;   ///< name of the token; "" where none is needed
  std::optional<Problem> refusal;
  httplib::Headers headers;  ///< that go with the answer
};

}  // namespace rouleau::service
