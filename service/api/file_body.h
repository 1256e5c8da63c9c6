#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include <httplib.h>

namespace rouleau::service {

/// Answers with `length` bytes of a file from `first` on, read as they are sent. The file stays open
/// meanwhile, so that its replacement does no harm.
/// @param while_sent  kept until the last byte is sent
/// @throws std::system_error if it cannot be opened
void answer_file(const std::filesystem::path& file, std::uint64_t first, std::uint64_t length,
                 const std::string& content_type, httplib::Response& response,
                 std::shared_ptr<const void> while_sent = {});

}  // namespace rouleau::service
