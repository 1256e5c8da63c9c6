#include <iostream>
#include <memory>

#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "engine/plan/plan.h"
#include "service/commands/case_file.h"
#include "service/commands/command.h"
#include "service/http/problem.h"

namespace rouleau::service {

void add_validate(CLI::App& app, Action& action) {
  auto* const command =
      app.add_subcommand("validate", "Check a case; print every fault with its JSON Pointer");
  const auto file = std::make_shared<std::string>();
  command->add_option("CASE.json", *file, "The case")->required();
  command->add_flag("--json", action.json, "Print the resolved case, or the faults, as JSON");
  command->callback([&action, file] {
    action.run = [&action, file] {
      const Case resolved = read_case(read_case_file(*file), check_effects);
      if (action.json) {
        std::cout << dump({{"valid", true}, {"case", to_json(resolved)}}) << '\n';
      } else {
        std::cout << *file << " is valid\n";
      }
      return exit_done;
    };
  });
}

}  // namespace rouleau::service
