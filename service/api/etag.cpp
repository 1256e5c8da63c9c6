#include "service/api/etag.h"

#include "service/api/query.h"
#include "storage/sha256.h"

namespace rouleau::service {

namespace {

std::string_view opaque(std::string_view tag) {
  const auto first = tag.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  tag = tag.substr(first, tag.find_last_not_of(" \t") - first + 1);
  return tag.starts_with("W/") ? tag.substr(2) : tag;
}

}  // namespace

std::string weak_etag(std::string_view body) {
  return "W/\"" + storage::sha256_hex(body).substr(0, 32) + "\"";
}

bool names_etag(std::string_view list, std::string_view etag) {
  for (const std::string& tag : split_list(list)) {
    if (opaque(tag) == "*" || opaque(tag) == opaque(etag)) return true;
  }
  return false;
}

bool answer_not_modified(const Call& call, const std::string& etag, httplib::Response& response) {
  response.set_header("ETag", etag);
  if (!names_etag(call.request.get_header_value("If-None-Match"), etag)) return false;
  response.status = 304;
  return true;
}

}  // namespace rouleau::service
