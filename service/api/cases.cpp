#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "service/api/case_body.h"
#include "service/api/service.h"
#include "service/case_hash.h"
#include "service/http/guarded_server.h"

namespace rouleau::service {

void add_cases(Router& router, Service& service) {
  router.add(
      "POST", "/v1/cases:validate",
      [](const Call& call, httplib::Response& response) {
        const PlannedCase planned = plan_case(read_body(call.request.body), "");
        answer_json({{"case", to_json(planned.resolved)}, {"case_hash", case_hash(planned.resolved)}},
                    response);
      },
      Body::json, Scope::read);
  router.add(
      "POST", "/v1/cases:plan",
      [&service](const Call& call, httplib::Response& response) {
        answer_json(to_json(plan_case(read_body(call.request.body), "", &service.machine).plan), response);
      },
      Body::json, Scope::read);
  router.add("GET", "/v1/schema/case.json", [](const Call&, httplib::Response& response) {
    response.set_content(dump(case_schema()), "application/schema+json");
  });
}

}  // namespace rouleau::service
