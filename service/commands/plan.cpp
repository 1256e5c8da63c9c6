#include "engine/plan/plan.h"

#include <iostream>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "service/commands/case_file.h"
#include "service/commands/command.h"
#include "service/http/problem.h"

namespace rouleau::service {

namespace {

void print(const Plan& plan) {
  for (const PlannedEffect& effect : plan.effects) {
    std::cout << fmt::format("{:3} {:28} {:10} {}{}\n", effect.on ? "on" : "off", effect.name, effect.stage,
                             effect.reason, effect.pointer.empty() ? "" : " (" + effect.pointer + ")");
  }
  std::cout << fmt::format(
      "\n{} particles, {} membrane nodes among them, and {} wall nodes at a spacing of {:.4g} m\n"
      "time step {:.4g} s, limited by {}; {} steps\n",
      plan.particles, plan.membrane_nodes, plan.wall_nodes, plan.spacing, plan.time_step, plan.limited_by,
      plan.steps);
}

}  // namespace

void add_plan(CLI::App& app, Action& action) {
  auto* const command =
      app.add_subcommand("plan", "Say which effects a case calls for and why, before it runs");
  const auto file = std::make_shared<std::string>();
  command->add_option("CASE.json", *file, "The case")->required();
  command->add_flag("--json", action.json, "Print the plan as JSON");
  command->callback([&action, file] {
    action.run = [&action, file] {
      const Plan plan = make_plan(read_case(read_case_file(*file), check_effects));
      if (action.json) {
        std::cout << dump(to_json(plan)) << '\n';
      } else {
        print(plan);
      }
      return exit_done;
    };
  });
}

}  // namespace rouleau::service
