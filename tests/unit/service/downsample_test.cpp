#include "service/api/downsample.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace rouleau::service {
namespace {

/// A quiet curve with two narrow peaks, and a slope.
storage::SeriesTable example(std::size_t rows) {
  storage::SeriesTable table{{{"time", "s"}, {"a", "1"}, {"b", "1"}}, {{}, {}, {}}};
  for (std::size_t row = 0; row < rows; ++row) {
    const auto t = static_cast<double>(row);
    table.values[0].push_back(t);
    table.values[1].push_back(std::sin(1e-2 * t) + (row == 333 ? 50.0 : 0.0) - (row == 777 ? 50.0 : 0.0));
    table.values[2].push_back(3 * t);
  }
  return table;
}

bool holds(const std::vector<std::size_t>& rows, std::size_t row) {
  return std::binary_search(rows.begin(), rows.end(), row);
}

TEST(Downsample, LeavesFewRowsAsTheyAre) {
  EXPECT_EQ(downsample(example(5), 5), (std::vector<std::size_t>{0, 1, 2, 3, 4}));
  EXPECT_TRUE(downsample({}, 5).empty());
}

TEST(Downsample, KeepsEndsAndExtremesWithinTheNumberAskedFor) {
  for (const std::size_t most : {10u, 20u, 100u, 999u}) {
    const auto rows = downsample(example(1000), most);
    EXPECT_LE(rows.size(), most);
    EXPECT_GE(rows.size(), most / 2);
    EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end()));
    for (const std::size_t row : {0u, 333u, 777u, 999u}) EXPECT_TRUE(holds(rows, row)) << most << ' ' << row;
  }
}

TEST(Downsample, KeepsExtremesEvenBeyondTheNumberAskedFor) {
  const auto rows = downsample(example(1000), 2);
  EXPECT_EQ(rows, (std::vector<std::size_t>{0, 333, 777, 999}));
}

TEST(Downsample, IsNotMisledByNaN) {
  auto table = example(1000);
  table.values[1][0] = table.values[1][500] = std::numeric_limits<double>::quiet_NaN();
  const auto rows = downsample(table, 10);
  EXPECT_TRUE(holds(rows, 333));
  EXPECT_TRUE(holds(rows, 777));
}

}  // namespace
}  // namespace rouleau::service
