#include "service/api/series_table.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "service/http/problem.h"

namespace rouleau::service {
namespace {

storage::SeriesTable example() {
  return {{{"time", "s"}, {"cell0.u", "m/s"}},
          {{0, 0.1, 0.2}, {1, 1.0 / 3.0, std::numeric_limits<double>::quiet_NaN()}}};
}

TEST(SeriesTable, IsJsonWithNullForWhatIsNotFinite) {
  EXPECT_EQ(series_json(example()), nlohmann::json::parse(R"({
    "columns": ["time", "cell0.u"], "units": {"time": "s", "cell0.u": "m/s"},
    "rows": [[0.0, 1.0], [0.1, 0.3333333333333333], [0.2, null]]})"));
  EXPECT_EQ(series_json({}), nlohmann::json::parse(R"({"columns": [], "units": {}, "rows": []})"));
}

TEST(SeriesTable, IsCsvThatReadsBackToTheSameBits) {
  EXPECT_EQ(series_csv(example()), "time,cell0.u\n0,1\n0.1,0.3333333333333333\n0.2,\n");
}

TEST(SeriesTable, SelectsRowsAfterATime) {
  EXPECT_EQ(rows_after(example(), 0.1).values[0], (std::vector<double>{0.2}));
  EXPECT_EQ(rows_after(example(), -1).values[0].size(), 3u);
  EXPECT_TRUE(rows_after(example(), 5).values[0].empty());
  EXPECT_EQ(rows_after(example(), 5).columns.size(), 2u);
}

TEST(SeriesTable, SelectsColumnsInTheOrderNamed) {
  const auto table = select_columns(example(), {"cell0.u", "time"});
  EXPECT_EQ(table.columns[0].name, "cell0.u");
  EXPECT_EQ(table.values[1][2], 0.2);
  EXPECT_EQ(select_columns(example(), {}).columns.size(), 2u);
}

TEST(SeriesTable, NamesEveryUnknownColumn) {
  try {
    select_columns(example(), {"a", "time", "b"});
    FAIL();
  } catch (const Problem& problem) {
    EXPECT_EQ(problem.kind().name, "unknown-column");
    EXPECT_EQ(problem.faults().size(), 2u);
  }
}

}  // namespace
}  // namespace rouleau::service
