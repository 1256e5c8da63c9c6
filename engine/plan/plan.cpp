#include "engine/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include <nlohmann/json.hpp>

#include "engine/case/case_error.h"
#include "engine/case/scales.h"
#include "engine/case/waveform.h"
#include "engine/effects/effect.h"
#include "engine/observe/observer.h"
#include "engine/plan/expected_spans.h"

namespace rouleau {

namespace {

// Fraction of a spacing that the fastest fluid moves in a step. The
// explicit transport of pressure would allow 0.5.
constexpr double courant = 0.2;

/// What the plan reads of an effect or an observer.
struct Candidate {
  std::string_view name;
  std::string_view stage;
  bool optional;
  effects::Need (*need)(const Case& scene);
  std::string_view rests;
  const std::vector<effects::Parameter>* parameters;
  const effects::EffectKind* effect = nullptr;  ///< one of the two
  const observe::ObserverKind* observer = nullptr;
};

const std::vector<Candidate>& candidates() {
  static const std::vector<Candidate> all = [] {
    std::vector<Candidate> found;
    for (const effects::EffectKind* kind : effects::catalogue()) {
      found.push_back({kind->name, name_of(kind->stage), kind->optional, kind->need, kind->rests,
                       &kind->parameters, kind});
    }
    for (const observe::ObserverKind* kind : observe::catalogue()) {
      found.push_back({kind->name, name_of(effects::Stage::observers), kind->optional, kind->need, "",
                       &kind->parameters, nullptr, kind});
    }
    return found;
  }();
  return all;
}

std::string known_effects() {
  std::string names;
  for (const Candidate& one : candidates()) names += (names.empty() ? "" : ", ") + std::string(one.name);
  return names;
}

Switch wish_for(const Case& scene, std::string_view name) {
  const auto wish = scene.effects.find(std::string(name));
  return wish == scene.effects.end() ? Switch::automatic : wish->second.position;
}

/// Those of a candidate, each with its value in the scene.
std::vector<PlannedEffect::Parameter> parameters_of(const Candidate& one, const Case& scene) {
  struct Named {
    std::string_view name;
    const std::vector<effects::Parameter>& parameters;
  };
  const Named named{one.name, *one.parameters};
  std::vector<PlannedEffect::Parameter> planned;
  for (const effects::Parameter& p : *one.parameters) {
    planned.push_back({std::string(p.name), std::string(p.unit), std::string(p.description),
                       effects::parameter(scene, named, p.name), p.least, p.most});
  }
  return planned;
}

PlannedEffect plan_effect(const Candidate& one, const Case& scene) {
  const effects::Need need = one.need(scene);
  PlannedEffect planned{.name = std::string(one.name),
                        .stage = std::string(one.stage),
                        .on = need.called_for,
                        .reason = need.reason,
                        .pointer = need.pointer,
                        .rests = std::string(one.rests),
                        .parameters = parameters_of(one, scene)};
  if (need.called_for && wish_for(scene, one.name) == Switch::off) {
    planned.on = false;
    planned.reason = "switched off by the case";
    planned.pointer = "/effects/" + planned.name;
  } else if (need.on_request && wish_for(scene, one.name) == Switch::on) {
    planned.on = true;
    planned.reason = "switched on by the case";
    planned.pointer = "/effects/" + planned.name;
  }
  return planned;
}

std::string names_of(const std::vector<effects::Parameter>& parameters) {
  std::string names;
  for (const effects::Parameter& one : parameters)
    names += (names.empty() ? "" : ", ") + std::string(one.name);
  return names;
}

void check_parameters(const Candidate& one, const std::map<std::string, double>& given,
                      const std::string& pointer, std::vector<Fault>& faults) {
  for (const auto& [name, value] : given) {
    const auto declared =
        std::find_if(one.parameters->begin(), one.parameters->end(),
                     [&name = name](const effects::Parameter& p) { return p.name == name; });
    if (declared == one.parameters->end()) {
      const std::string allowed = names_of(*one.parameters);
      faults.push_back({pointer + "/" + name,
                        "unknown parameter; " + (allowed.empty() ? "it has none" : "it has: " + allowed)});
    } else if (!(value >= declared->least && value <= declared->most)) {
      std::ostringstream text;
      text << "found " << value << "; allowed is a number from " << declared->least << " to "
           << declared->most;
      if (declared->unit != "1") text << ' ' << declared->unit;
      faults.push_back({pointer + "/" + name, text.str()});
    }
  }
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

double expected_time(const Candidate& one, const ExpectedSpan& span) {
  return one.effect != nullptr ? expected_time(*one.effect, span.rounds, span.work)
                               : expected_time(*one.observer, span.rounds, span.work);
}

/// Shares, time and memory.
void expect_cost(const std::vector<ExpectedSpan>& spans, Plan& plan) {
  const ExpectedSpan& first = spans.front();
  double of_effects = 0, of_run = 0, of_step = 0;
  for (std::size_t k = 0; k < plan.effects.size(); ++k) {
    PlannedEffect& planned = plan.effects[k];
    if (!planned.on) continue;
    const Candidate& one = candidates()[k];
    for (const ExpectedSpan& span : spans) planned.share += expected_time(one, span);
    of_effects += planned.share;
    of_step +=
        effects::cost_of(one.effect != nullptr ? one.effect->cost : one.observer->cost.step, first.work);
  }
  for (PlannedEffect& planned : plan.effects) planned.share /= of_effects;
  for (const ExpectedSpan& span : spans) {
    plan.expected_steps += span.rounds.steps;
    of_run += expected_time_of_steps(span);
  }
  const double ns = 1e-9;
  plan.step_time =
      ns * (of_step + expected_time_of_steps(first) / (first.rounds.steps + first.rounds.settling));
  plan.wall_time = (starting_time + ns * (of_effects + of_run)) * plan.machine.slowness;
  plan.memory = expected_memory(spans);
}

}  // namespace

bool runs(const Plan& plan, std::string_view name) {
  return std::any_of(plan.effects.begin(), plan.effects.end(),
                     [&](const PlannedEffect& e) { return e.on && e.name == name; });
}

void check_effects(Case& scene, std::vector<Fault>& faults) {
  const auto& all = candidates();
  for (auto& entry : scene.effects) {
    const std::string& name = entry.first;
    const Switch wish = entry.second.position;
    const std::string pointer = "/effects/" + name;
    const auto one = std::find_if(all.begin(), all.end(), [&](const Candidate& c) { return c.name == name; });
    if (one == all.end()) {
      faults.push_back({pointer, "no effect has this name; there are: " + known_effects()});
      continue;
    }
    check_parameters(*one, entry.second.parameters, pointer, faults);
    if (wish == Switch::on) {
      for (const effects::Parameter& p : *one->parameters) {
        entry.second.parameters.try_emplace(std::string(p.name), p.fallback);
      }
    }
    const effects::Need need = one->need(scene);
    if (wish == Switch::on && !need.called_for && !need.on_request) {
      faults.push_back({pointer, "\"on\", but " + need.reason + "; use \"auto\" or \"off\""});
    } else if (wish == Switch::off && need.called_for && !one->optional) {
      faults.push_back({pointer, "\"off\", but " + need.reason + ": this effect cannot be left out"});
    }
  }
}

Plan make_plan(const Case& scene, const Machine& machine) {
  std::vector<Fault> faults;
  Case checked = scene;
  check_effects(checked, faults);
  if (!faults.empty()) throw CaseError(std::move(faults));
  Plan plan;
  plan.machine = machine;
  for (const Candidate& one : candidates()) plan.effects.push_back(plan_effect(one, scene));

  const double diameter = scene.vessel.diameter;
  plan.spacing = diameter / std::round(diameter / scene.numerics.spacing);
  const effects::State state(scene, scales_of(scene), plan.spacing / diameter);
  const auto nodes = state.outline.wall_nodes(state.spacing, 0);
  plan.wall_nodes = static_cast<int>(nodes.size());
  plan.particles = count_particles(state, nodes);
  plan.membrane_nodes = count_membrane_nodes(scene, plan.spacing);

  const double fastest = fastest_expected(state) * state.scales.velocity;
  const double usual_step = courant * plan.spacing / fastest;
  double step = usual_step;
  plan.limited_by = "flow: the fastest fluid may move a fifth of the spacing in a step";
  if (scene.numerics.time_step) {
    step = *scene.numerics.time_step;
    plan.limited_by = "given by the case";
  }
  plan.steps = static_cast<long>(std::ceil(scene.duration / step * (1 - 1e-9)));
  plan.time_step = scene.duration / static_cast<double>(plan.steps);

  const StartCounts counts{static_cast<double>(plan.particles), static_cast<double>(plan.membrane_nodes),
                           static_cast<double>(plan.wall_nodes)};
  const auto spans = expected_spans(state, counts, plan.spacing, plan.time_step, fastest);
  expect_cost(spans, plan);
  plan.expected_error = expect_error(state, spans.back().spacing, spans.front().step, usual_step);
  return plan;
}

nlohmann::json to_json(const Plan& plan) {
  nlohmann::json effects = nlohmann::json::array();
  for (const PlannedEffect& e : plan.effects) {
    nlohmann::json parameters = nlohmann::json::array();
    for (const PlannedEffect::Parameter& p : e.parameters) {
      parameters.push_back({{"name", p.name},
                            {"unit", p.unit},
                            {"description", p.description},
                            {"value", p.value},
                            {"least", p.least},
                            {"most", p.most}});
    }
    effects.push_back({{"name", e.name},
                       {"stage", e.stage},
                       {"on", e.on},
                       {"reason", e.reason},
                       {"pointer", e.pointer},
                       {"rests", e.rests},
                       {"share", e.share},
                       {"parameters", parameters}});
  }
  return {{"effects", effects},
          {"spacing", plan.spacing},
          {"particles", plan.particles},
          {"wall_nodes", plan.wall_nodes},
          {"membrane_nodes", plan.membrane_nodes},
          {"time_step", plan.time_step},
          {"limited_by", plan.limited_by},
          {"steps", plan.steps},
          {"expected_steps", std::llround(plan.expected_steps)},
          {"memory_bytes", std::llround(plan.memory)},
          {"wall_time_s", plan.wall_time},
          {"machine", {{"slowness", plan.machine.slowness}, {"measured", plan.machine.measured}}},
          {"expected_error",
           {{"velocity", plan.expected_error.velocity},
            {"tau", plan.expected_error.tau ? nlohmann::json(*plan.expected_error.tau) : nlohmann::json()},
            {"is", expected_error_is}}}};
}

}  // namespace rouleau
