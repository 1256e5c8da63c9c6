#include "service/commands/command.h"

#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/case/case_error.h"
#include "engine/simulation/run.h"
#include "service/client/server_error.h"
#include "service/http/problem.h"

namespace rouleau::service {

namespace {

/// "  /vessel/length: must be ..." a line.
std::string block(const std::string& headline, const std::vector<Fault>& faults) {
  std::string text = "error: " + headline + '\n';
  for (const Fault& fault : faults) {
    text += "  " + (fault.pointer.empty() ? std::string("(the whole)") : fault.pointer) + ": " +
            fault.message + '\n';
  }
  return text;
}

int report(const std::string& headline, const std::vector<Fault>& faults, int exit_code, bool json) {
  std::cerr << block(headline, faults);
  if (json) {
    nlohmann::json body{{"error", headline}, {"errors", nlohmann::json::array()}};
    for (const Fault& fault : faults) {
      body["errors"].push_back({{"pointer", fault.pointer}, {"message", fault.message}});
    }
    std::cout << dump(body) << '\n';
  }
  return exit_code;
}

int run_action(const Action& action) {
  try {
    return action.run();
  } catch (const CaseError& error) {
    const auto count = error.faults().size();
    return report("the case has " + std::to_string(count) + (count == 1 ? " fault" : " faults"),
                  error.faults(), exit_bad_input, action.json);
  } catch (const ServerError& error) {
    return report(error.what(), error.faults(), error.is_bad_input() ? exit_bad_input : exit_failed,
                  action.json);
  } catch (const Problem& problem) {
    return report(problem.detail(), problem.faults(), exit_bad_input, action.json);
  } catch (const CommandError& error) {
    return report(error.what(), {}, error.exit_code(), action.json);
  } catch (const std::exception& error) {
    return report(error.what(), {}, exit_failed, action.json);
  }
}

}  // namespace

int run_command_line(int argc, char** argv) {
  CLI::App app{"Rouleau: red cells passing a thrombus, computed by a particle method.", "rouleau"};
  app.require_subcommand(1);
  app.set_version_flag("--version", engine_version());
  app.get_formatter()->column_width(34);
  app.footer("Exit codes: 0 done, 1 the run failed, 2 bad input or usage.");

  Action action;
  for (const auto add : {add_validate, add_plan, add_run, add_series, add_sweep, add_bench, add_serve,
                         add_token, add_submit, add_status, add_wait, add_logs, add_fetch, add_job_actions,
                         add_delete, add_queue, add_doctor, add_backup, add_restore}) {
    add(app, action);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_done : exit_bad_input;
  }
  return run_action(action);
}

}  // namespace rouleau::service
