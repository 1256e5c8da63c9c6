#include <utility>

#include "service/api/service.h"

namespace rouleau::service {

void add_metrics(Router& router, std::function<std::string()> text) {
  router.add("GET", "/metrics", [text = std::move(text)](const Call&, httplib::Response& response) {
    response.set_content(text(), "text/plain; version=0.0.4; charset=utf-8");
  });
}

}  // namespace rouleau::service
