#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "engine/case/case.h"
#include "engine/case/case_error.h"
#include "engine/plan/expected_error.h"
#include "engine/plan/machine.h"

namespace rouleau {

/// One line of the plan: an effect or observer that the catalogues know, whether this scene runs it, and why.
struct PlannedEffect {
  /// A number that the case may give it.
  struct Parameter {
    std::string name;
    std::string unit;  ///< SI; "1" where it has none
    std::string description;
    double value = 0;  ///< the case's, else the default
    double least = 0, most = 0;
  };

  std::string name;
  std::string stage;
  bool on = false;
  std::string reason;   ///< a sentence for a person
  std::string pointer;  ///< JSON Pointer to the part of the case that decided, "" if none did
  std::string rests;    ///< when it sleeps inside a run, as a part of a sentence; "" if never
  double share = 0;     ///< of the time that all of them together are expected to take; 0 where it is off
  std::vector<Parameter> parameters{};
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
  double expected_steps = 0;  ///< with those that are foreseen to be taken smaller, or again
  double step_time = 0;       ///< of a step at the start, s, on the machine to which costs refer
  double wall_time = 0;       ///< of the run, s, on the machine that the plan is for, with nothing else to do
  double memory = 0;          ///< of a process that runs it and writes its archive, bytes
  ExpectedError expected_error;
  Machine machine;
};

/// Whether the plan runs an effect or observer.
bool runs(const Plan& plan, std::string_view name);

/// Faults of the case's `effects`: names that no effect has, parameters that it does not have or that are out
/// of range, "on" for what the scene cannot carry, "off" for what it cannot do without. Fills in the
/// parameters that the case leaves out. To be given to `read_case`, which then reports the faults with all
/// others.
void check_effects(Case& resolved, std::vector<Fault>& faults);

/// @throws CaseError where `effects` asks for what the scene cannot carry, or leaves out what it needs
Plan make_plan(const Case& resolved, const Machine& machine = {});

nlohmann::json to_json(const Plan& plan);

}  // namespace rouleau
