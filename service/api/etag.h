#pragma once

#include <string>
#include <string_view>

#include "service/http/router.h"

namespace rouleau::service {

/// Of a body that may be compressed on its way, hence weak.
std::string weak_etag(std::string_view body);

/// Whether a list of tags (If-None-Match) names this one, or is "*". Weak comparison.
bool names_etag(std::string_view list, std::string_view etag);

/// Sets the tag, and answers 304 if the client has that state already.
bool answer_not_modified(const Call& call, const std::string& etag, httplib::Response& response);

}  // namespace rouleau::service
