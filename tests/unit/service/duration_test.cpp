#include "service/http/duration.h"

#include <gtest/gtest.h>

namespace rouleau::service {
namespace {

using std::chrono::milliseconds;

TEST(Duration, TakesUnitsOrPlainSeconds) {
  EXPECT_EQ(parse_duration("20s"), milliseconds(20000));
  EXPECT_EQ(parse_duration("500ms"), milliseconds(500));
  EXPECT_EQ(parse_duration("2m"), milliseconds(120000));
  EXPECT_EQ(parse_duration("1.5"), milliseconds(1500));
  EXPECT_EQ(parse_duration("0s"), milliseconds(0));
}

TEST(Duration, RefusesEverythingElse) {
  for (const char* const text :
       {"", "s", "-1s", "1h", "1 s", "nan", "inf", "1e9s", "1s ", "999999999m", "0x5s"}) {
    EXPECT_FALSE(parse_duration(text)) << text;
  }
}

}  // namespace
}  // namespace rouleau::service
