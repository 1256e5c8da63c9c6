#include "service/http/problem.h"
#include "service/http/request_head.h"
#include "tests/fuzz/targets.h"

namespace rouleau::fuzz {

void request_head(std::string_view input) {
  const service::RequestLimits limits;
  service::RequestHead head;
  try {
    head = service::read_request_head(input, limits);
  } catch (const service::Problem&) {
    return;
  }
  must(head.content_length <= limits.body_bytes);
  must(head.headers.size() <= limits.headers);
  must(service::path_of(head.target).size() <= head.target.size());
  // What cpp-httplib gets to read is the same request, with one length and no range.
  service::RequestLimits with_length = limits;
  ++with_length.headers;
  const auto shown = service::read_request_head(service::head_for_httplib(head), with_length);
  must(shown.method == head.method && shown.target == head.target && shown.version == head.version);
  must(shown.content_length == head.content_length);
  must(shown.header("Range").empty() && shown.header("Expect").empty());
  must(shown.header("Host") == head.header("Host"));
}

}  // namespace rouleau::fuzz
