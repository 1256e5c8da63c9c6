#include "service/commands/fetch_archive.h"

#include <fstream>
#include <regex>

#include "service/commands/client_options.h"
#include "storage/archive_writer.h"

namespace rouleau::service {

namespace {

/// The sidecar names the archive that it belongs to: the job's own, or another's whose result it was given.
std::string renamed(const std::string& sidecar, const std::string& name) {
  static const std::regex archive("[0-9a-f]{8}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{12}\\.h5");
  return std::regex_replace(sidecar, archive, name);
}

}  // namespace

nlohmann::json fetch_archive(ApiClient& client, const std::string& id, const std::filesystem::path& file) {
  const std::string path = job_path(id);
  const Download archive = client.download(path + "/archive.h5", file);
  const auto sidecar = storage::sidecar_path(file);
  if (!archive.was_there || !std::filesystem::exists(sidecar)) {
    std::ofstream(sidecar, std::ios::binary)
        << renamed(client.get_text(path + "/archive.xdmf"), file.filename().string());
  }
  return {{"archive", file.string()},
          {"xdmf", sidecar.string()},
          {"size", archive.size},
          {"sha256", archive.sha256},
          {"was_there", archive.was_there}};
}

bool has_no_archive(const ServerError& error) {
  return error.status() == 409 || error.status() == 404 || error.status() == 410;
}

}  // namespace rouleau::service
