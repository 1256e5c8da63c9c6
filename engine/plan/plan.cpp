#include "engine/plan/plan.h"

#include <cmath>
#include <numbers>

#include <nlohmann/json.hpp>

#include "engine/case/case_error.h"
#include "engine/case/scales.h"
#include "engine/effects/effect.h"

namespace rouleau {

namespace {

using effects::EffectKind;

// Fraction of a spacing that the fastest fluid moves in a step. Time errors are of first order in it; the
// explicit transport of pressure would allow 0.5.
constexpr double courant = 0.2;

PlannedEffect plan_effect(const EffectKind& kind, const Case& scene, std::vector<Fault>& faults) {
  const effects::Need need = kind.need(scene);
  PlannedEffect planned{std::string(kind.name), std::string(name_of(kind.stage)), need.called_for,
                        need.reason, need.pointer};
  const auto wish = scene.effects.find(planned.name);
  if (wish == scene.effects.end() || wish->second == Switch::automatic) return planned;
  const std::string pointer = "/effects/" + planned.name;
  if (wish->second == Switch::on && !need.called_for) {
    faults.push_back({pointer, "\"on\", but " + need.reason + "; use \"auto\" or \"off\""});
  } else if (wish->second == Switch::off && need.called_for && !kind.optional) {
    faults.push_back({pointer, "\"off\", but " + need.reason + ": this effect cannot be left out"});
  } else if (wish->second == Switch::off && need.called_for) {
    planned.on = false;
    planned.reason = "switched off by the case";
    planned.pointer = pointer;
  }
  return planned;
}

void find_unknown_effects(const Case& scene, std::vector<Fault>& faults) {
  for (const auto& [name, wish] : scene.effects) {
    std::string known;
    bool found = false;
    for (const EffectKind* kind : effects::catalogue()) {
      found = found || kind->name == name;
      known += (known.empty() ? "" : ", ") + std::string(kind->name);
    }
    if (!found) faults.push_back({"/effects/" + name, "no effect has this name; there are: " + known});
  }
}

int count_membrane_nodes(const Case& scene, double spacing) {
  int nodes = 0;
  for (const RedCell& cell : scene.cells) {
    nodes += static_cast<int>(std::lround(std::numbers::pi * cell.diameter / spacing));
  }
  return nodes;
}

}  // namespace

Plan make_plan(const Case& scene) {
  Plan plan;
  std::vector<Fault> faults;
  find_unknown_effects(scene, faults);
  for (const EffectKind* kind : effects::catalogue()) {
    plan.effects.push_back(plan_effect(*kind, scene, faults));
  }
  if (!faults.empty()) throw CaseError(std::move(faults));

  const double diameter = scene.vessel.diameter;
  plan.spacing = diameter / std::round(diameter / scene.numerics.spacing);
  const effects::State state(scene, scales_of(scene), plan.spacing / diameter);
  double lumen = scene.vessel.length * diameter;
  for (const Thrombus& t : scene.thrombi) lumen -= std::numbers::pi * t.radius * t.radius / 2;
  plan.particles = static_cast<int>(
      std::lround(lumen / (plan.spacing * plan.spacing) - scene.vessel.length / plan.spacing));
  plan.wall_nodes = static_cast<int>(state.outline.wall_nodes(state.spacing, 0).size());
  plan.membrane_nodes = count_membrane_nodes(scene, plan.spacing);

  const double fastest = 1.5 * scene.inflow.velocity * state.outline.height() / state.outline.narrowest();
  double step = courant * plan.spacing / fastest;
  plan.limited_by = "flow: the fastest fluid may move a fifth of the spacing in a step";
  if (scene.numerics.time_step) {
    step = *scene.numerics.time_step;
    plan.limited_by = "given by the case";
  }
  plan.steps = static_cast<long>(std::ceil(scene.duration / step * (1 - 1e-9)));
  plan.time_step = scene.duration / static_cast<double>(plan.steps);
  return plan;
}

nlohmann::json to_json(const Plan& plan) {
  nlohmann::json effects = nlohmann::json::array();
  for (const PlannedEffect& e : plan.effects) {
    effects.push_back(
        {{"name", e.name}, {"stage", e.stage}, {"on", e.on}, {"reason", e.reason}, {"pointer", e.pointer}});
  }
  return {{"effects", effects},
          {"spacing", plan.spacing},
          {"particles", plan.particles},
          {"wall_nodes", plan.wall_nodes},
          {"membrane_nodes", plan.membrane_nodes},
          {"time_step", plan.time_step},
          {"limited_by", plan.limited_by},
          {"steps", plan.steps}};
}

}  // namespace rouleau
