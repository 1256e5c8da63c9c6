#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "engine/case/case.h"
#include "engine/case/case_error.h"

namespace rouleau {

/// One line of the plan: an effect or observer that the catalogues know, whether this scene runs it, and why.
struct PlannedEffect {
  std::string name;
  std::string stage;
  bool on = false;
  std::string reason;   ///< a sentence for a person
  std::string pointer;  ///< JSON Pointer to the part of the case that decided, "" if none did
  std::string rests;    ///< when it sleeps inside a run, as a part of a sentence; "" if never
};

/// What will run, known before anything runs.
struct Plan {
  std::vector<PlannedEffect> effects;
  double spacing = 0;  ///< d0 used, m (the given one, fitted to the vessel's diameter)
  int particles = 0;   ///< moving particles at the start: plasma, inner fluid, membrane
  int wall_nodes = 0;
  int membrane_nodes = 0;
  double time_step = 0;    ///< s
  std::string limited_by;  ///< what holds the time step there
  long steps = 0;
};

/// Whether the plan runs an effect or observer.
bool runs(const Plan& plan, std::string_view name);

/// Faults of the case's `effects`: names that no effect has, parameters that it does not have or that are out
/// of range, "on" for what the scene cannot carry, "off" for what it cannot do without. Fills in the
/// parameters that the case leaves out. To be given to `read_case`, which then reports the faults with all
/// others.
void check_effects(Case& resolved, std::vector<Fault>& faults);

/// @throws CaseError where `effects` asks for what the scene cannot carry, or leaves out what it needs
Plan make_plan(const Case& resolved);

nlohmann::json to_json(const Plan& plan);

}  // namespace rouleau
