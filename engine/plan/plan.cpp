#include "engine/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <nlohmann/json.hpp>

#include "engine/case/case_error.h"
#include "engine/case/scales.h"
#include "engine/case/waveform.h"
#include "engine/effects/effect.h"

namespace rouleau {

namespace {

using effects::EffectKind;

// Fraction of a spacing that the fastest fluid moves in a step. The
// explicit transport of pressure would allow 0.5.
constexpr double courant = 0.2;

std::string known_effects() {
  std::string names;
  for (const EffectKind* kind : effects::catalogue()) {
    names += (names.empty() ? "" : ", ") + std::string(kind->name);
  }
  return names;
}

Switch wish_for(const Case& scene, const EffectKind& kind) {
  const auto wish = scene.effects.find(std::string(kind.name));
  return wish == scene.effects.end() ? Switch::automatic : wish->second;
}

PlannedEffect plan_effect(const EffectKind& kind, const Case& scene) {
  const effects::Need need = kind.need(scene);
  PlannedEffect planned{std::string(kind.name), std::string(name_of(kind.stage)), need.called_for,
                        need.reason, need.pointer};
  if (need.called_for && wish_for(scene, kind) == Switch::off) {
    planned.on = false;
    planned.reason = "switched off by the case";
    planned.pointer = "/effects/" + planned.name;
  } else if (need.on_request && wish_for(scene, kind) == Switch::on) {
    planned.on = true;
    planned.reason = "switched on by the case";
    planned.pointer = "/effects/" + planned.name;
  }
  return planned;
}

int count_membrane_nodes(const Case& scene, double spacing) {
  int nodes = 0;
  for (const RedCell& cell : scene.cells) {
    nodes += static_cast<int>(std::lround(std::numbers::pi * cell.diameter / spacing));
  }
  return nodes;
}

/// The nodes on a wall stand for half a spacing of fluid beside it.
int count_particles(const effects::State& state, const std::vector<geometry::WallNode>& nodes) {
  double wall = 0;
  for (const geometry::WallNode& node : nodes) wall += node.length;
  const double d0 = state.spacing;
  return static_cast<int>(std::lround(state.outline.area() / (d0 * d0) - wall / (2 * d0)));
}

/// In own units: of a parabola through the narrowest place, or the unit of velocity itself.
double fastest_expected(const effects::State& state) {
  if (!is_open(state.scene.vessel)) return state.scene.body_acceleration[0] != 0 ? 1.5 : 1;
  return 1.5 * largest_factor(state.scene.inflow) * state.outline.height() / state.outline.narrowest();
}

}  // namespace

void check_effects(const Case& scene, std::vector<Fault>& faults) {
  const auto& kinds = effects::catalogue();
  for (const auto& entry : scene.effects) {
    const std::string& name = entry.first;
    const Switch wish = entry.second;
    const std::string pointer = "/effects/" + name;
    const auto kind =
        std::find_if(kinds.begin(), kinds.end(), [&](const EffectKind* k) { return k->name == name; });
    if (kind == kinds.end()) {
      faults.push_back({pointer, "no effect has this name; there are: " + known_effects()});
      continue;
    }
    const effects::Need need = (*kind)->need(scene);
    if (wish == Switch::on && !need.called_for && !need.on_request) {
      faults.push_back({pointer, "\"on\", but " + need.reason + "; use \"auto\" or \"off\""});
    } else if (wish == Switch::off && need.called_for && !(*kind)->optional) {
      faults.push_back({pointer, "\"off\", but " + need.reason + ": this effect cannot be left out"});
    }
  }
}

Plan make_plan(const Case& scene) {
  std::vector<Fault> faults;
  check_effects(scene, faults);
  if (!faults.empty()) throw CaseError(std::move(faults));
  Plan plan;
  for (const EffectKind* kind : effects::catalogue()) plan.effects.push_back(plan_effect(*kind, scene));

  const double diameter = scene.vessel.diameter;
  plan.spacing = diameter / std::round(diameter / scene.numerics.spacing);
  const effects::State state(scene, scales_of(scene), plan.spacing / diameter);
  const auto nodes = state.outline.wall_nodes(state.spacing, 0);
  plan.wall_nodes = static_cast<int>(nodes.size());
  plan.particles = count_particles(state, nodes);
  plan.membrane_nodes = count_membrane_nodes(scene, plan.spacing);

  double step = courant * plan.spacing / (fastest_expected(state) * state.scales.velocity);
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
