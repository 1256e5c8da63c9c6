#include "storage/checkpoint_file.h"

#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

#include "engine/error/checkpoint_error.h"
#include "storage/archive_error.h"
#include "storage/durable_file.h"
#include "storage/sha256.h"

namespace rouleau::storage {

namespace {

// A line that names the file, one with the SHA-256 of what follows, then the bytes of the engine.
const std::string first_line = "rouleau checkpoint\n";
constexpr std::size_t sum_length = 64;
const std::size_t head_length = first_line.size() + sum_length + 1;
// A run of the most particles that a case may have takes a tenth of this.
constexpr std::uintmax_t largest = std::uintmax_t{4} << 30;

std::string_view text_of(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

ArchiveError failure(const std::filesystem::path& path, const char* what) {
  const auto kind =
      errno == ENOSPC || errno == EDQUOT ? ArchiveError::Kind::disk_full : ArchiveError::Kind::io;
  return ArchiveError(kind,
                      std::string(what) + path.string() + ": " + std::generic_category().message(errno));
}

}  // namespace

std::filesystem::path checkpoint_path(const std::filesystem::path& archive) {
  return std::filesystem::path(archive) += ".checkpoint";
}

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
  const auto aside = std::filesystem::path(path) += ".part";
  std::ofstream file(aside, std::ios::binary | std::ios::trunc);
  const std::string_view bytes = text_of(checkpoint.bytes);
  file << first_line << sha256_hex(bytes) << '\n' << bytes;
  file.close();
  if (file) return publish(aside, path);
  const ArchiveError error = failure(path, "cannot write ");
  std::error_code ignored;
  std::filesystem::remove(aside, ignored);
  throw error;
}

Checkpoint read_checkpoint(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  if (!file || error) throw failure(path, "cannot read ");
  std::string head(head_length, '\0');
  if (size < head_length || size > largest ||
      !file.read(head.data(), static_cast<std::streamsize>(head_length)) || !head.starts_with(first_line)) {
    throw CheckpointError(path.string() + " is no checkpoint");
  }
  Checkpoint checkpoint;
  checkpoint.bytes.resize(static_cast<std::size_t>(size - head_length));
  file.read(reinterpret_cast<char*>(checkpoint.bytes.data()),
            static_cast<std::streamsize>(checkpoint.bytes.size()));
  if (!file || head.substr(first_line.size(), sum_length) != sha256_hex(text_of(checkpoint.bytes))) {
    throw CheckpointError(path.string() + " is damaged: its checksum does not fit");
  }
  return checkpoint;
}

}  // namespace rouleau::storage
