#pragma once

#include <cstddef>
#include <filesystem>

#include "service/http/router.h"

namespace rouleau::service {

/// Reads the files of the web page into memory and adds a route for each, "/" for index.html. Nothing of a
/// client's path is ever looked up on the disk.
/// @return how many files there were; 0 if there is no such folder
std::size_t add_page(Router& router, const std::filesystem::path& folder);

}  // namespace rouleau::service
