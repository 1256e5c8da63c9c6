#include "engine/plan/plan.h"

#include <iostream>
#include <memory>

#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "service/commands/case_file.h"
#include "service/commands/command.h"
#include "service/commands/plan_text.h"
#include "service/http/problem.h"
#include "service/known_machine.h"

namespace rouleau::service {

namespace {

struct Options {
  std::string file;
  std::filesystem::path data;
  bool calibrate = false;
};

Machine machine_of(const Options& options) {
  KnownMachine known(options.data);
  if (const auto kept = known.kept(); kept && !options.calibrate) return *kept;
  std::cerr << "measuring how fast this machine is; kept in " << known.file().string() << '\n';
  return known.measure();
}

}  // namespace

void add_plan(CLI::App& app, Action& action) {
  auto* const command = app.add_subcommand(
      "plan", "Say which effects a case calls for and why, and what it will take, before it runs");
  const auto options = std::make_shared<Options>();
  options->data = default_data_folder();
  command->add_option("CASE.json", options->file, "The case")->required();
  command->add_option("--data", options->data, "Folder in which the machine's speed is kept")
      ->envname("ROULEAU_DATA")
      ->capture_default_str();
  command->add_flag("--calibrate", options->calibrate, "Measure the machine's speed again");
  command->add_flag("--json", action.json, "Print the plan as JSON");
  command->callback([&action, options] {
    action.run = [&action, options] {
      const Case resolved = read_case(read_case_file(options->file), check_effects);
      const Plan plan = make_plan(resolved, machine_of(*options));
      std::cout << (action.json ? dump(to_json(plan)) + "\n" : describe_plan(plan));
      return exit_done;
    };
  });
}

}  // namespace rouleau::service
