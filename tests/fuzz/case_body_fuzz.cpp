#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "service/api/case_body.h"
#include "tests/fuzz/targets.h"

namespace rouleau::fuzz {

void case_body(std::string_view input) {
  service::PlannedCase planned;
  try {
    planned = service::plan_case(service::read_body(std::string(input)), "");
  } catch (const service::Problem& problem) {
    service::dump(service::to_json(problem, ""));
    return;
  }
  // What is kept of a job is the resolved case: it is a case too, the same one.
  const std::string resolved = service::dump(to_json(planned.resolved));
  const auto again = service::plan_case(service::read_body(resolved), "");
  must(service::dump(to_json(again.resolved)) == resolved);
}

}  // namespace rouleau::fuzz
