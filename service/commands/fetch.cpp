#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "service/commands/client_options.h"
#include "service/commands/command.h"
#include "service/http/problem.h"
#include "storage/archive_writer.h"
#include "storage/sha256.h"

namespace rouleau::service {

namespace {

/// The sidecar names the archive that it belongs to.
std::string renamed(std::string text, const std::string& from, const std::string& to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

int fetch(const ClientOptions& options, const std::string& id, const std::string& output, bool json) {
  ApiClient client = options.connect();
  const std::string path = job_path(id);
  const std::filesystem::path file = output.empty() ? id + ".h5" : output;
  const std::string sha256 = client.download(path + "/archive.h5", file);
  if (storage::sha256_hex_of_file(file) != sha256) {
    throw std::runtime_error(file.string() + " differs from the server's archive; fetch it again");
  }
  const auto sidecar = storage::sidecar_path(file);
  std::ofstream(sidecar, std::ios::binary)
      << renamed(client.get_text(path + "/archive.xdmf"), id + ".h5", file.filename().string());
  if (json) {
    std::cout << dump({{"archive", file.string()},
                       {"xdmf", sidecar.string()},
                       {"size", std::filesystem::file_size(file)},
                       {"sha256", sha256}})
              << '\n';
  } else {
    std::cout << file.string() << '\n';
  }
  return exit_done;
}

}  // namespace

void add_fetch(CLI::App& app, Action& action) {
  auto* const command =
      app.add_subcommand("fetch", "Download the archive of a job that succeeded or went unstable");
  const auto options = std::make_shared<ClientOptions>();
  const auto id = std::make_shared<std::string>();
  const auto output = std::make_shared<std::string>();
  command->add_option("ID", *id, "The job")->required();
  command->add_option("-o,--output", *output, "Where to (default: ID.h5, here)");
  command->add_flag("--json", action.json, "Print name, size and sha256 as JSON");
  add_client_options(*command, *options);
  command->callback([&action, options, id, output] {
    action.run = [&action, options, id, output] { return fetch(*options, *id, *output, action.json); };
  });
}

}  // namespace rouleau::service
