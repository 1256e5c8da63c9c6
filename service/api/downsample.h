#pragma once

#include <cstddef>
#include <vector>

#include "storage/archive_reader.h"

namespace rouleau::service {

/// Which rows of a table to show where it has more than `most` of them, in order: the first, the last, those
/// that hold the least and the greatest value of each column, and of what is left of `most`, one a stretch of
/// time, that which lies furthest from its neighbours' line. At most max(most, 2 columns + 2) rows.
std::vector<std::size_t> downsample(const storage::SeriesTable& table, std::size_t most);

}  // namespace rouleau::service
