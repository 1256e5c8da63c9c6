#include "engine/case/case_json.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "engine/case/bounded_json.h"
#include "engine/case/case_keys.h"
#include "engine/case/case_members.h"
#include "engine/case/key_checks.h"
#include "engine/case/part_checks.h"
#include "engine/case/scene_checks.h"

namespace rouleau {
namespace {

Case read_with(const nlohmann::json& document, const CaseCheck& further, Faults& faults) {
  const nlohmann::json sound = sound_part(document, case_key(), "", faults);
  if (sound.is_null()) faults.raise();
  Case result = case_from_sound(sound);
  check_parts(sound, result, faults);
  check_scene(result, faults);
  std::vector<Fault> found;
  if (further) further(result, found);
  for (Fault& fault : found) faults.add(std::move(fault.pointer), std::move(fault.message));
  faults.raise();
  return result;
}

}  // namespace

Case read_case(std::string_view text, const CaseCheck& further) {
  Faults faults;
  const nlohmann::json document = parse_bounded(text, faults);
  return read_with(document, further, faults);
}

template <std::same_as<nlohmann::json> Json>
Case read_case(const Json& document, const CaseCheck& further) {
  Faults faults;
  return read_with(document, further, faults);
}

template Case read_case(const nlohmann::json& document, const CaseCheck& further);

}  // namespace rouleau
