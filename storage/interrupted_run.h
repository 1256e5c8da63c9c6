#pragma once

#include <filesystem>
#include <optional>

#include "engine/simulation/checkpoint.h"
#include "engine/simulation/output.h"

namespace rouleau::storage {

/// A run that was interrupted: its last checkpoint, and an archive that has all that it delivered by then.
struct InterruptedRun {
  Checkpoint checkpoint;
  CheckpointHead head;
  std::filesystem::path archive;
};

/// The name of an unfinished archive of an earlier run while another is made from it.
std::filesystem::path put_aside_path(const std::filesystem::path& archive);

/// What an earlier run of a case left beside its archive, whether it was stopped or killed. An unfinished
/// archive is put aside so that another can be begun under its name; `ResumedOutput` removes it.
/// @return nothing if it left no checkpoint
/// @throws CheckpointError if its checkpoint is damaged or another case's, or its archive is gone;
/// ArchiveError
std::optional<InterruptedRun> find_interrupted(const std::filesystem::path& archive, const Case& resolved);

/// To be told of a run that goes on from a checkpoint, behind the archive's writer: as soon as that has begun
/// it gets what the run delivered before, and so becomes the same archive as if the run had never stopped.
class ResumedOutput : public Output {
 public:
  ResumedOutput(InterruptedRun run, Output& target) : run_(std::move(run)), target_(target) {}

  void begin(const RunHeader& header) override;

 private:
  InterruptedRun run_;
  Output& target_;
};

/// Keeps the last checkpoint of a run beside its archive.
class CheckpointKeeper : public Output {
 public:
  explicit CheckpointKeeper(const std::filesystem::path& archive);

  void checkpoint(const Checkpoint& checkpoint) override;
  /// Once nothing is to go on from: the run is over, or one begins from the start.
  void remove();

 private:
  std::filesystem::path archive_;
};

}  // namespace rouleau::storage
