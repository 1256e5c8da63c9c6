#include "service/commands/plan_text.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "service/commands/progress_line.h"

namespace rouleau::service {

namespace {

constexpr std::size_t widest = 120;

std::string with_pointer(const PlannedEffect& effect) {
  return effect.reason + (effect.pointer.empty() ? "" : " (" + effect.pointer + ")");
}

std::string share_of(const PlannedEffect& effect) {
  return effect.share < 0.0005 ? "  < 0.1 %" : fmt::format("{:7.1f} %", 100 * effect.share);
}

/// A line a reason, with all the effects that it holds for.
class ByReason {
 public:
  void add(const std::string& reason, const std::string& name) {
    const auto known =
        std::find_if(reasons_.begin(), reasons_.end(), [&](const auto& one) { return one.first == reason; });
    if (known != reasons_.end()) {
      known->second.push_back(name);
    } else {
      reasons_.push_back({reason, {name}});
    }
  }

  std::string text(const std::string& title) const {
    std::string text = reasons_.empty() ? "" : "\n" + title + "\n";
    for (const auto& [reason, names] : reasons_) {
      std::string line = "  " + reason + ":";
      for (const std::string& name : names) {
        if (line.size() + name.size() > widest) {
          text += line + "\n";
          line = "     ";
        }
        line += " " + name + (&name == &names.back() ? "" : ",");
      }
      text += line + "\n";
    }
    return text;
  }

 private:
  std::vector<std::pair<std::string, std::vector<std::string>>> reasons_;
};

std::string describe_parameters(const PlannedEffect& effect) {
  std::string text;
  for (const PlannedEffect::Parameter& p : effect.parameters) {
    text += fmt::format("{}{} {:.4g}{}", text.empty() ? "             with " : ", ", p.name, p.value,
                        p.unit == "1" ? "" : " " + p.unit);
  }
  return text.empty() ? text : text + "\n";
}

/// What costs most first.
std::string describe_running(const Plan& plan) {
  std::vector<const PlannedEffect*> running;
  for (const PlannedEffect& effect : plan.effects) {
    if (effect.on) running.push_back(&effect);
  }
  std::stable_sort(running.begin(), running.end(),
                   [](const PlannedEffect* a, const PlannedEffect* b) { return a->share > b->share; });
  std::string text = "what will run, and its share of the time\n";
  ByReason sleeping;
  for (const PlannedEffect* effect : running) {
    text += fmt::format("{}  {:28} {:10} {}\n", share_of(*effect), effect->name, effect->stage,
                        with_pointer(*effect));
    text += describe_parameters(*effect);
    if (!effect->rests.empty()) sleeping.add(effect->rests, effect->name);
  }
  return text + sleeping.text("of these sleep");
}

std::string describe_left_out(const Plan& plan) {
  ByReason reasons;
  for (const PlannedEffect& effect : plan.effects) {
    if (!effect.on) reasons.add(with_pointer(effect), effect.name);
  }
  return reasons.text("what is left out");
}

std::string percent(double share) {
  return fmt::format("{:.2g} %", 100 * share);
}

std::string describe_numbers(const Plan& plan) {
  std::string text =
      fmt::format("\nparticles       {}, {} of them membrane nodes; {} wall nodes; {:.4g} um apart\n",
                  plan.particles, plan.membrane_nodes, plan.wall_nodes, 1e6 * plan.spacing);
  text += fmt::format("time step       {:.4g} us, {} steps ({})\n", 1e6 * plan.time_step, plan.steps,
                      plan.limited_by);
  const long expected = std::lround(plan.expected_steps);
  if (expected > plan.steps + plan.steps / 50) {
    text += fmt::format("                some {} steps, as part of them will be shorter or taken again\n",
                        expected);
  }
  text += fmt::format("memory          {:.0f} MB\n", plan.memory / 1e6);
  const std::string time =
      plan.wall_time < 100 ? fmt::format("{:.2g} s", plan.wall_time) : format_time_left(plan.wall_time);
  const std::string machine =
      plan.machine.measured
          ? fmt::format("this machine ({:.2f} times that of the one costs refer to)", plan.machine.slowness)
          : "a machine like the one costs refer to";
  text += fmt::format("time            {} on {}\n", time, machine);
  text += fmt::format("expected error  velocity {}", percent(plan.expected_error.velocity));
  if (plan.expected_error.tau) text += fmt::format(", tau {}", percent(*plan.expected_error.tau));
  return text +
         "\n                root mean square difference from a run with half of the spacing and step:"
         "\n                velocity at the end, tau over the run\n";
}

}  // namespace

std::string describe_plan(const Plan& plan) {
  return describe_running(plan) + describe_left_out(plan) + describe_numbers(plan);
}

}  // namespace rouleau::service
