#include "service/api/query.h"
#include "service/api/service.h"

namespace rouleau::service {

namespace {

void get_log(Service& service, const Call& call, httplib::Response& response) {
  check_query(call, {"from_byte"});
  const int from = query_integer(call, "from_byte", 0, 1'000'000'000).value_or(0);
  const storage::Job job = find_job(service, call);
  response.set_content(service.queue.logs().read(job, static_cast<std::uint64_t>(from)),
                       "text/plain; charset=utf-8");
}

}  // namespace

void add_log(Router& router, Service& service) {
  router.add("GET", "/v1/jobs/{id}/log",
             [&service](const Call& call, httplib::Response& response) { get_log(service, call, response); });
}

}  // namespace rouleau::service
