#include "service/api/case_body.h"

#include <utility>

#include "engine/case/case_json.h"

namespace rouleau::service {

nlohmann::json read_body(const std::string& body) {
  try {
    return parse_json(body);
  } catch (const CaseError& error) {
    throw Problem(problems::invalid_json, "the body could not be read", error.faults());
  }
}

PlannedCase plan_case(const nlohmann::json& document, const std::string& pointer, KnownMachine* machine) {
  try {
    PlannedCase planned;
    planned.resolved = read_case(document, check_effects);
    planned.plan = make_plan(planned.resolved, machine != nullptr ? machine->get() : Machine{});
    return planned;
  } catch (const CaseError& error) {
    std::vector<Fault> faults = error.faults();
    for (Fault& fault : faults) fault.pointer.insert(0, pointer);
    const auto count = faults.size();
    throw Problem(problems::invalid_case,
                  "the case has " + std::to_string(count) + (count == 1 ? " fault" : " faults"),
                  std::move(faults));
  }
}

}  // namespace rouleau::service
