#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace rouleau::storage {

/// In lower-case hex.
std::string sha256_hex(std::string_view bytes);
/// @throws std::system_error if the file cannot be read
std::string sha256_hex_of_file(const std::filesystem::path& path);

}  // namespace rouleau::storage
