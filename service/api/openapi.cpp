#include "service/api/openapi.h"

#include "service/api/service.h"

namespace rouleau::service {

void add_openapi(Router& router) {
  router.add("GET", "/openapi.json", [](const Call&, httplib::Response& response) {
    response.set_content(openapi_text(), "application/json");
  });
}

}  // namespace rouleau::service
