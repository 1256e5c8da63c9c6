#include <iostream>
#include <memory>

#include <nlohmann/json.hpp>

#include "service/commands/command.h"
#include "service/http/token_file.h"

namespace rouleau::service {

namespace {

struct TokenOptions {
  std::string name;
  std::string scopes = "read,submit";
};

void print_new_token(const TokenOptions& options, bool json) {
  const auto scope = parse_scopes(options.scopes);
  if (!is_token_name(options.name)) {
    throw CommandError(exit_bad_input, "a name has 1 to 64 letters, digits, '-', '_' and '.'");
  }
  if (!scope) throw CommandError(exit_bad_input, "--scopes takes read, submit and admin, with commas");
  const std::string token = new_token();
  const std::string line = token_line(options.name, *scope, token);
  if (json) {
    std::cout << nlohmann::json{{"token", token}, {"line", line}}.dump() << '\n';
  } else {
    std::cout << "The token, shown this once, for whoever calls (--token or ROULEAU_TOKEN):\n\n  " << token
              << "\n\nIts line for the token file of `rouleau serve`, which reads it on SIGHUP:\n\n  " << line
              << '\n';
  }
}

}  // namespace

void add_token(CLI::App& app, Action& action) {
  auto* const command =
      app.add_subcommand("token", "Make a token for a service that others may call (serve --token-file)");
  const auto options = std::make_shared<TokenOptions>();
  command->add_option("NAME", options->name, "Who calls with it; jobs take turns by this name")->required();
  command->add_option("--scopes", options->scopes, "read, submit (and read), admin (all)")
      ->capture_default_str();
  command->add_flag("--json", action.json, "Print both as JSON");
  command->callback([&action, options] {
    action.run = [&action, options] {
      print_new_token(*options, action.json);
      return exit_done;
    };
  });
}

}  // namespace rouleau::service
