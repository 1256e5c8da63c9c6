#include "engine/case/case_keys.h"

#include <algorithm>

#include "engine/case/key_ranges.h"
#include "engine/case/run_keys.h"
#include "engine/case/scene_keys.h"

namespace rouleau {
namespace {

Key whole_case() {
  return {.name = "case",
          .kind = Kind::object,
          .description =
              "One scene: SI units, angles in degrees, x along the vessel from the inlet, y across it "
              "from the lower wall.",
          .members = {
              {.name = "version",
               .kind = Kind::integer,
               .description = "Of this format.",
               .range = only(1),
               .required = true},
              {.name = "name",
               .kind = Kind::text,
               .description = "What people call the case.",
               .fallback = "",
               .most_entries = max_name_length},
              vessel_key(),
              plasma_key(),
              inflow_key(),
              outflow_key(),
              body_acceleration_key(),
              initial_key(),
              thrombi_key(),
              cells_key(),
              effects_key(),
              numerics_key(),
              {.name = "duration",
               .description = "Simulated time.",
               .unit = "s",
               .range = above(0, 1e5),
               .required = true},
              output_key(),
              probes_key(),
          }};
}

}  // namespace

bool Range::holds(double value) const {
  if (or_zero && value == 0) return true;
  return (above_least ? value > least : value >= least) && (below_most ? value < most : value <= most);
}

Key entry_of(const Key& list) {
  Key entry = list;
  entry.kind = list.entries;
  return entry;
}

std::vector<Key> members_of(const Key& object, const Variant& variant) {
  std::vector<Key> members = object.members;
  members.insert(members.end(), variant.members.begin(), variant.members.end());
  return members;
}

const Key& case_key() {
  static const Key key = whole_case();
  return key;
}

bool is_lower_snake_case(std::string_view name) {
  const auto letter = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto allowed = [letter](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; };
  return !name.empty() && letter(name.front()) && name.back() != '_' &&
         name.find("__") == std::string_view::npos && std::all_of(name.begin(), name.end(), allowed);
}

bool is_identifier(std::string_view name) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return !name.empty() && std::all_of(name.begin(), name.end(), allowed);
}

}  // namespace rouleau
