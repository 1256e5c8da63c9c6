#include "service/api/service.h"

namespace rouleau::service {

void add_health(Router& router, const std::atomic<bool>& draining) {
  router.add("GET", "/livez",
             [](const Call&, httplib::Response& response) { response.set_content("ok\n", "text/plain"); });
  router.add("GET", "/readyz", [&draining](const Call&, httplib::Response& response) {
    response.status = draining ? 503 : 200;
    response.set_content(draining ? "draining\n" : "ready\n", "text/plain");
  });
}

}  // namespace rouleau::service
