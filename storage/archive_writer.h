#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/simulation/output.h"
#include "engine/simulation/run.h"
#include "storage/archive/xdmf.h"
#include "storage/archive_error.h"

namespace rouleau::storage {

class UnfinishedFile;

struct ArchiveFile {
  std::uint64_t size = 0;  ///< bytes
  std::string sha256;      ///< hex
};

/// Writes what a run delivers to one HDF5 file (layout: docs/archive.md). The file grows as NAME.part beside
/// its final name, is flushed with every frame, and takes its name in `finish`, complete and on the disk; if
/// that never comes, the destructor removes it, unless a checkpoint relies on it. Each call may throw
/// ArchiveError.
class ArchiveWriter : public Output {
 public:
  /// @param path        final name, conventionally ending in .h5; its folder must exist
  /// @param case_given  the case as the user wrote it
  ArchiveWriter(std::filesystem::path path, std::string case_given);
  ~ArchiveWriter() override;
  ArchiveWriter(const ArchiveWriter&) = delete;
  ArchiveWriter& operator=(const ArchiveWriter&) = delete;

  void begin(const RunHeader& header) override;
  void series_row(std::span<const double> row) override;
  void probe_row(double time, std::span<const ProbeValues> row) override;
  void frame(const Frame& frame) override;
  /// Puts all that it was given on the disk.
  void checkpoint(const Checkpoint& checkpoint) override;

  /// Writes how the run ended and publishes the archive, with an .xdmf beside it for ParaView.
  ArchiveFile finish(const RunSummary& summary);

 private:
  struct Parts;

  template <class Work>
  void write(Work&& work);
  template <class Work>
  void work_or_discard(Work&& work);
  void discard();

  std::filesystem::path path_;
  std::string case_given_;
  std::unique_ptr<UnfinishedFile> file_;
  std::unique_ptr<Parts> parts_;
  XdmfContent sidecar_;
};

/// Where an archive grows until it is finished. An ArchiveReader of the same process can open it there.
std::filesystem::path unfinished_path(const std::filesystem::path& path);

/// The sidecar's name: OUT.h5 -> OUT.xdmf.
std::filesystem::path sidecar_path(const std::filesystem::path& path);

}  // namespace rouleau::storage
