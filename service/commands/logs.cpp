#include <chrono>
#include <iostream>
#include <memory>
#include <thread>

#include "service/commands/client_options.h"
#include "service/commands/command.h"

namespace rouleau::service {

namespace {

struct Options : ClientOptions {
  std::string id;
  bool follow = false;
};

int logs(const Options& options) {
  constexpr std::chrono::seconds interval{1};
  ApiClient client = options.connect();
  const std::string job = job_path(options.id);
  std::size_t shown = 0;
  bool is_last = !options.follow;
  for (;;) {
    const std::string text = client.get_text(job + "/log?from_byte=" + std::to_string(shown));
    std::cout << text << std::flush;
    shown += text.size();
    if (is_last) return exit_done;
    // Once more after its end, for the end is written when it is on record.
    is_last = !client.get(job).at("ended_at").is_null();
    std::this_thread::sleep_for(interval);
  }
}

}  // namespace

void add_logs(CLI::App& app, Action& action) {
  auto* const command = app.add_subcommand("logs", "Show the log of a job of a running service");
  const auto options = std::make_shared<Options>();
  command->add_option("ID", options->id, "The job")->required();
  command->add_flag("-f,--follow", options->follow, "Go on until the job has ended");
  add_client_options(*command, *options);
  command->callback([&action, options] { action.run = [options] { return logs(*options); }; });
}

}  // namespace rouleau::service
