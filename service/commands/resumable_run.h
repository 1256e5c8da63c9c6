#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>

#include "engine/case/case.h"
#include "engine/plan/machine.h"
#include "engine/simulation/output.h"
#include "engine/simulation/run.h"
#include "engine/simulation/run_failure.h"
#include "storage/archive_writer.h"
#include "storage/interrupted_run.h"

namespace rouleau::service {

/// A case and the archive that its run is to leave.
struct ResumableRun {
  std::filesystem::path archive;
  std::string given;  ///< the case as the user wrote it
  const Case& resolved;
  double checkpoint_interval = 60;  ///< s of wall time; 0: none
  Machine machine;
};

struct RunEnd {
  RunSummary summary;
  std::optional<RunFailure> failure;  ///< it went unstable
  storage::ArchiveFile file;          ///< whole as far as the run came, also if it was stopped or failed
};

/// Runs it from its start, or from where `interrupted` says, with checkpoints beside the archive. They stay
/// if the run was stopped, and are removed once nothing is left to go on with.
/// @param progress  is told, too, what the run delivers
/// @throws CaseError, ArchiveError
RunEnd run_resumable(const ResumableRun& run, const std::optional<storage::InterruptedRun>& interrupted,
                     Output& progress, const std::stop_token& stop);

}  // namespace rouleau::service
