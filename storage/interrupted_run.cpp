#include "storage/interrupted_run.h"

#include <system_error>

#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "engine/error/checkpoint_error.h"
#include "storage/archive.h"
#include "storage/archive/replay.h"
#include "storage/checkpoint_file.h"

namespace rouleau::storage {

namespace {

namespace fs = std::filesystem;

bool has_all(const fs::path& archive, const CheckpointHead& head, const Case& resolved) {
  if (!fs::exists(archive)) return false;
  try {
    return ArchiveReader(archive).case_resolved() == to_json(resolved) && can_replay(archive, head);
  } catch (const ArchiveError&) {
    return false;
  }
}

}  // namespace

fs::path put_aside_path(const fs::path& archive) {
  return fs::path(archive) += ".before";
}

std::optional<InterruptedRun> find_interrupted(const fs::path& archive, const Case& resolved) {
  const fs::path saved = checkpoint_path(archive);
  if (!fs::exists(saved)) return std::nullopt;
  InterruptedRun run{read_checkpoint(saved), {}, {}};
  run.head = head_of(run.checkpoint, resolved);
  for (const fs::path& path : {put_aside_path(archive), unfinished_path(archive), archive}) {
    if (!has_all(path, run.head, resolved)) continue;
    run.archive = path;
    if (path != unfinished_path(archive)) return run;
    run.archive = put_aside_path(archive);
    fs::rename(path, run.archive);
    return run;
  }
  throw CheckpointError("there is a checkpoint, " + saved.string() +
                        ", but no archive with what the run had delivered by then");
}

void ResumedOutput::begin(const RunHeader&) {
  replay(run_.archive, run_.head, target_);
  target_.checkpoint(run_.checkpoint);
  if (run_.archive.extension() == ".before") fs::remove(run_.archive);
}

CheckpointKeeper::CheckpointKeeper(const fs::path& archive) : archive_(archive) {}

void CheckpointKeeper::checkpoint(const Checkpoint& checkpoint) {
  write_checkpoint(checkpoint_path(archive_), checkpoint);
}

void CheckpointKeeper::remove() {
  fs::remove(checkpoint_path(archive_));
  fs::remove(fs::path(checkpoint_path(archive_)) += ".part");  // whoever wrote it was killed
  fs::remove(put_aside_path(archive_));
  fs::remove(unfinished_path(archive_));
}

}  // namespace rouleau::storage
