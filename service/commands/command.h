#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include <CLI/CLI.hpp>

namespace rouleau::service {

inline constexpr int exit_done = 0;
inline constexpr int exit_failed = 1;
inline constexpr int exit_bad_input = 2;

/// What the command line asks for; its result is the exit code. Set while the line is parsed.
struct Action {
  std::function<int()> run;
  bool json = false;  ///< --json was given: standard output is for programs
};

/// A command that cannot go on, in words for the user.
class CommandError : public std::runtime_error {
 public:
  CommandError(int exit_code, const std::string& message)
      : std::runtime_error(message), exit_code_(exit_code) {}
  int exit_code() const { return exit_code_; }

 private:
  int exit_code_;
};

// One file a command; each adds itself to the line.
void add_validate(CLI::App& app, Action& action);
void add_plan(CLI::App& app, Action& action);
void add_run(CLI::App& app, Action& action);
void add_series(CLI::App& app, Action& action);
void add_sweep(CLI::App& app, Action& action);
void add_bench(CLI::App& app, Action& action);
void add_serve(CLI::App& app, Action& action);
void add_token(CLI::App& app, Action& action);
void add_submit(CLI::App& app, Action& action);
void add_status(CLI::App& app, Action& action);
void add_wait(CLI::App& app, Action& action);
void add_fetch(CLI::App& app, Action& action);
void add_logs(CLI::App& app, Action& action);
void add_job_actions(CLI::App& app, Action& action);  ///< cancel, pause, resume, retry
void add_delete(CLI::App& app, Action& action);
void add_queue(CLI::App& app, Action& action);
void add_doctor(CLI::App& app, Action& action);
void add_backup(CLI::App& app, Action& action);
void add_restore(CLI::App& app, Action& action);

/// Parses and runs; every error ends up on standard error as one block.
/// @return the exit code
int run_command_line(int argc, char** argv);

}  // namespace rouleau::service
