#include "engine/case/case_json.h"

#include <nlohmann/json.hpp>

#include "engine/case/bounded_json.h"
#include "engine/case/case_keys.h"
#include "engine/case/case_members.h"
#include "engine/case/key_checks.h"
#include "engine/case/scene_checks.h"

namespace rouleau {
namespace {

Case read_with(const nlohmann::json& document, Faults& faults) {
  const nlohmann::json sound = sound_part(document, case_key(), "", faults);
  if (sound.is_null()) faults.raise();
  Case result = case_from_sound(sound);
  check_scene(result, faults);
  faults.raise();
  return result;
}

}  // namespace

Case read_case(std::string_view text) {
  Faults faults;
  const nlohmann::json document = parse_bounded(text, faults);
  return read_with(document, faults);
}

template <std::same_as<nlohmann::json> Json>
Case read_case(const Json& document) {
  Faults faults;
  return read_with(document, faults);
}

template Case read_case(const nlohmann::json& document);

}  // namespace rouleau
