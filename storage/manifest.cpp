#include "storage/manifest.h"

#include <algorithm>
#include <fstream>

#include <nlohmann/json.hpp>

#include "storage/archive_error.h"
#include "storage/durable_file.h"

namespace rouleau::storage {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int manifest_version = 1;

bool is_sha256(const std::string& text) {
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

/// Whether a path stays in the folder that it is joined to.
bool stays_inside(const fs::path& path) {
  return !path.empty() && path.is_relative() &&
         std::none_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".."; });
}

ManifestFile file_of(const json& entry) {
  ManifestFile file{entry.at("path").get<std::string>(), entry.at("size").get<std::uint64_t>(),
                    entry.at("sha256").get<std::string>()};
  if (!stays_inside(file.path) || !is_sha256(file.sha256)) {
    throw ArchiveError(ArchiveError::Kind::format, "names a file that no data folder has: " + file.path);
  }
  return file;
}

Manifest manifest_of(const json& document) {
  if (const int version = document.at("version").get<int>(); version != manifest_version) {
    throw ArchiveError(ArchiveError::Kind::format, "is of version " + std::to_string(version) +
                                                       "; restore it with the program that made it");
  }
  Manifest manifest;
  manifest.created_at = document.at("created_at").get<TimeMs>();
  manifest.engine = document.at("engine").get<std::string>();
  manifest.schema = document.at("schema").get<int>();
  manifest.jobs = document.at("jobs").get<std::int64_t>();
  manifest.missing = document.at("missing").get<std::vector<std::string>>();
  for (const json& entry : document.at("files")) manifest.files.push_back(file_of(entry));
  return manifest;
}

}  // namespace

fs::path manifest_path(const fs::path& backup) {
  return backup / manifest_name;
}

fs::path content_path(const fs::path& backup, const std::string& sha256) {
  return backup / "files" / sha256;
}

void write_manifest(const fs::path& backup, const Manifest& manifest) {
  json files = json::array();
  for (const ManifestFile& file : manifest.files) {
    files.push_back({{"path", file.path}, {"size", file.size}, {"sha256", file.sha256}});
  }
  const json document{{"version", manifest_version}, {"created_at", manifest.created_at},
                      {"engine", manifest.engine},   {"schema", manifest.schema},
                      {"jobs", manifest.jobs},       {"files", std::move(files)},
                      {"missing", manifest.missing}};
  fs::path aside = manifest_path(backup);
  aside += ".part";
  std::ofstream out(aside, std::ios::binary | std::ios::trunc);
  out << document.dump(1) << '\n';
  out.close();
  if (!out) throw ArchiveError(ArchiveError::Kind::io, aside.string() + ": could not be written");
  publish(aside, manifest_path(backup));
}

Manifest read_manifest(const fs::path& backup) {
  const fs::path path = manifest_path(backup);
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    throw ArchiveError(ArchiveError::Kind::io,
                       path.string() + " is not there: this is no backup, or one that was not finished");
  }
  try {
    return manifest_of(json::parse(in));
  } catch (const json::exception& error) {
    throw ArchiveError(ArchiveError::Kind::format, path.string() + " is damaged: " + error.what());
  } catch (const ArchiveError& error) {
    throw ArchiveError(error.kind(), path.string() + ' ' + error.what());
  }
}

}  // namespace rouleau::storage
