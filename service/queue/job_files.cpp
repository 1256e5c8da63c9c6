#include "service/queue/job_files.h"

#include <array>
#include <string>

#include "storage/archive_writer.h"
#include "storage/checkpoint_file.h"
#include "storage/interrupted_run.h"

namespace rouleau::service {

namespace {

namespace fs = std::filesystem;

constexpr std::array unfinished_extensions{".part", ".before", ".checkpoint"};

bool is_unfinished(const fs::path& file) {
  const auto extension = file.extension();
  for (const char* const each : unfinished_extensions) {
    if (extension == each) return true;
  }
  return false;
}

}  // namespace

fs::path archive_path(const fs::path& archives, std::string_view id) {
  return archives / (std::string(id) + ".h5");
}

void remove_archive(const fs::path& archives, std::string_view id) {
  const fs::path archive = archive_path(archives, id);
  fs::remove(archive);
  fs::remove(storage::sidecar_path(archive));
}

void remove_unfinished(const fs::path& archives, std::string_view id) {
  storage::CheckpointKeeper(archive_path(archives, id)).remove();
}

fs::path unfinished_archive(const fs::path& archives, std::string_view id) {
  const fs::path archive = archive_path(archives, id);
  for (const fs::path& path : {storage::put_aside_path(archive), storage::unfinished_path(archive)}) {
    if (fs::exists(path)) return path;
  }
  return {};
}

void tidy(const fs::path& archives, const std::function<bool(std::string_view id)>& goes_on) {
  for (const auto& entry : fs::directory_iterator(archives)) {
    const fs::path& file = entry.path();
    if (!is_unfinished(file)) continue;
    // ID.h5.part, but not ID.h5.checkpoint.part, which is half a checkpoint.
    const fs::path of_archive = file.stem();
    const std::string id = of_archive.stem();
    const bool needed = of_archive.extension() == ".h5" && goes_on(id) &&
                        fs::exists(storage::checkpoint_path(archive_path(archives, id)));
    if (!needed) fs::remove(file);
  }
}

}  // namespace rouleau::service
