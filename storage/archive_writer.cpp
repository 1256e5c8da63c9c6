#include "storage/archive_writer.h"

#include <fstream>

#include "storage/archive/outline_writer.h"
#include "storage/archive/parameters.h"
#include "storage/archive/probe_writer.h"
#include "storage/archive/series_writer.h"
#include "storage/archive/trajectory_writer.h"
#include "storage/archive/unfinished_file.h"
#include "storage/archive/wall_writer.h"
#include "storage/durable_file.h"
#include "storage/hdf5/session.h"
#include "storage/sha256.h"

namespace rouleau::storage {

namespace {

using hdf5::Session;

std::filesystem::path with_suffix(std::filesystem::path path, const char* suffix) {
  return path += suffix;
}

void write_sidecar(const std::filesystem::path& path, const XdmfContent& content) {
  const auto aside = with_suffix(path, ".part");
  std::ofstream file(aside, std::ios::binary | std::ios::trunc);
  file << xdmf_document(content);
  file.close();
  if (file) return publish(aside, path);
  std::error_code ignored;
  std::filesystem::remove(aside, ignored);
  throw ArchiveError(ArchiveError::Kind::io, "cannot write " + path.string());
}

}  // namespace

std::filesystem::path unfinished_path(const std::filesystem::path& path) {
  return with_suffix(path, ".part");
}

std::filesystem::path sidecar_path(const std::filesystem::path& path) {
  return std::filesystem::path(path).replace_extension(".xdmf");
}

/// What writes while a run lasts.
struct ArchiveWriter::Parts {
  Parts(hid_t file, const RunHeader& header)
      : series(file, header.columns),
        probes(file, header.probes),
        trajectory(file, header),
        outlines(file, header.nodes_per_cell, header.membrane_fields),
        walls(file, header.walls) {}

  void write_gathered() {
    series.write_gathered();
    probes.write_gathered();
  }

  SeriesWriter series;
  ProbeWriter probes;
  TrajectoryWriter trajectory;
  OutlineWriter outlines;
  WallWriter walls;
};

ArchiveWriter::ArchiveWriter(std::filesystem::path path, std::string case_given)
    : path_(std::move(path)), case_given_(std::move(case_given)) {}

ArchiveWriter::~ArchiveWriter() {
  if (!file_) return;
  const Session session;
  discard();
}

void ArchiveWriter::discard() {
  if (file_) file_->give_up();
  parts_.reset();
  file_.reset();
}

/// Whatever goes wrong, what was written so far is of no use.
template <class Work>
void ArchiveWriter::work_or_discard(Work&& work) {
  const Session session;
  try {
    work();
  } catch (...) {
    discard();
    throw;
  }
}

template <class Work>
void ArchiveWriter::write(Work&& work) {
  if (!parts_) throw ArchiveError(ArchiveError::Kind::misuse, path_.string() + " is not being written");
  work_or_discard(work);
}

void ArchiveWriter::begin(const RunHeader& header) {
  if (file_) throw ArchiveError(ArchiveError::Kind::misuse, path_.string() + " was begun before");
  work_or_discard([&] {
    file_ = std::make_unique<UnfinishedFile>(unfinished_path(path_), path_);
    write_parameters(file_->id(), header, case_given_);
    parts_ = std::make_unique<Parts>(file_->id(), header);
    file_->let_others_read();
  });
  sidecar_ = {.archive_name = path_.filename().string(),
              .times = {},
              .capacity = header.capacity,
              .nodes_per_cell = header.nodes_per_cell,
              .membrane_fields = header.membrane_fields,
              .velocity = carries(header.resolved, Field::velocity),
              .pressure = carries(header.resolved, Field::pressure)};
}

void ArchiveWriter::series_row(std::span<const double> row) {
  write([&] { parts_->series.add(row); });
}

void ArchiveWriter::probe_row(double time, std::span<const ProbeValues> row) {
  write([&] { parts_->probes.add(time, row); });
}

void ArchiveWriter::frame(const Frame& frame) {
  write([&] {
    parts_->write_gathered();
    parts_->outlines.add(frame);
    parts_->walls.add(frame);
    parts_->trajectory.add(frame);
    file_->flush();
  });
  sidecar_.times.push_back(frame.time);
}

void ArchiveWriter::checkpoint(const Checkpoint&) {
  write([&] {
    parts_->write_gathered();
    file_->flush();
    sync(file_->path());
    file_->keep();
  });
}

ArchiveFile ArchiveWriter::finish(const RunSummary& summary) {
  write([&] {
    parts_->write_gathered();
    file_->flush();
    parts_.reset();
    file_->reopen();
    write_ending(file_->id(), summary);
    file_->close();
  });
  ArchiveFile result;
  result.size = std::filesystem::file_size(file_->path());
  result.sha256 = sha256_hex_of_file(file_->path());
  write_sidecar(sidecar_path(path_), sidecar_);
  file_->publish();
  file_.reset();
  return result;
}

}  // namespace rouleau::storage
