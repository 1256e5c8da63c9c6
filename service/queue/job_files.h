#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace rouleau::service {

/// Where the archive that a job wrote lies once that job has succeeded, or failed with one. What its attempts
/// leave until then lies beside it.
std::filesystem::path archive_path(const std::filesystem::path& archives, std::string_view id);

/// Removes an archive with its sidecar.
void remove_archive(const std::filesystem::path& archives, std::string_view id);

/// Removes what the attempts at a job left: its checkpoint, and the archives that it never finished.
void remove_unfinished(const std::filesystem::path& archives, std::string_view id);

/// An archive that a job which has not ended has begun; the name of none if there is none to be read.
std::filesystem::path unfinished_archive(const std::filesystem::path& archives, std::string_view id);

/// At the start, when nothing runs: removes what dead attempts left, but for the jobs that go on from it.
void tidy(const std::filesystem::path& archives, const std::function<bool(std::string_view id)>& goes_on);

}  // namespace rouleau::service
