#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rouleau::service {

/// Bounds on a request, checked before any of its body is read.
struct RequestLimits {
  std::size_t head_bytes = 16384;
  std::size_t headers = 64;
  std::size_t target_bytes = 4096;
  std::size_t header_bytes = 8000;  ///< of one; cpp-httplib 0.11.4 gives up beyond 8192
  std::size_t body_bytes = 1 << 20;
};

/// The head of a request as it stood on the wire.
struct RequestHead {
  std::string method;
  std::string target;
  std::string version;
  std::vector<std::pair<std::string, std::string>> headers;
  std::size_t content_length = 0;

  /// The first header of that name (ASCII case does not count), "" if there is none.
  std::string_view header(std::string_view name) const;
};

/// Reads a head, from its first byte to the blank line that ends it, and refuses what cpp-httplib 0.11.4
/// would take: it bounds neither chunked nor compressed bodies and believes the first of two lengths.
/// @throws Problem 400, 411, 413, 414, 415 or 431
RequestHead read_request_head(std::string_view text, const RequestLimits& limits);

/// The head as cpp-httplib may see it: without `Range`, which it would apply without clamping (bytes past
/// the end are foreign memory), without `Accept-Encoding` (it would squeeze every answer with brotli at its
/// slowest, which costs more than the loopback saves), without `Expect`, which has been answered, and with a
/// `Content-Length` wherever it would otherwise read to the end of the connection.
std::string head_for_httplib(const RequestHead& head);

/// The path that a target names, %xx decoded.
std::string path_of(std::string_view target);

/// The parameters of its query, decoded; a value may hold an equals sign, which cpp-httplib 0.11.4 would cut
/// it at.
std::multimap<std::string, std::string> query_of(std::string_view target);

bool equal_ignoring_case(std::string_view a, std::string_view b);

}  // namespace rouleau::service
