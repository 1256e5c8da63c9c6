#include "service/http/byte_range.h"

#include <string>

#include <gtest/gtest.h>

namespace rouleau::service {
namespace {

using Kind = ByteRange::Kind;

struct Expected {
  const char* header;
  Kind kind;
  std::uint64_t first = 0, last = 0;
};

TEST(ByteRange, IsWhatRfc9110Says) {
  for (const Expected& expected : {Expected{"bytes=0-0", Kind::part, 0, 0},
                                   Expected{"bytes=0-", Kind::part, 0, 999},
                                   Expected{"BYTES=10-19", Kind::part, 10, 19},
                                   Expected{"bytes=990-2000", Kind::part, 990, 999},
                                   Expected{"bytes=999-", Kind::part, 999, 999},
                                   Expected{"bytes=-1", Kind::part, 999, 999},
                                   Expected{"bytes=-5000", Kind::part, 0, 999},
                                   Expected{"bytes=1000-", Kind::unsatisfiable},
                                   Expected{"bytes=5000-6000", Kind::unsatisfiable},
                                   Expected{"bytes=-0", Kind::unsatisfiable},
                                   Expected{"bytes=99999999999999999999999-", Kind::unsatisfiable},
                                   Expected{"bytes=0-99999999999999999999999", Kind::part, 0, 999},
                                   Expected{"", Kind::whole},
                                   Expected{"bytes=", Kind::whole},
                                   Expected{"bytes=-", Kind::whole},
                                   Expected{"bytes=5-2", Kind::whole},
                                   Expected{"bytes=0-1,5-6", Kind::whole},
                                   Expected{"bytes=--5", Kind::whole},
                                   Expected{"bytes=-5-", Kind::whole},
                                   Expected{"bytes=0x0-9", Kind::whole},
                                   Expected{"bytes= 0-9", Kind::whole},
                                   Expected{"items=0-9", Kind::whole}}) {
    const ByteRange range = parse_byte_range(expected.header, 1000);
    EXPECT_EQ(range.kind, expected.kind) << expected.header;
    if (expected.kind != Kind::part) continue;
    EXPECT_EQ(range.first, expected.first) << expected.header;
    EXPECT_EQ(range.last, expected.last) << expected.header;
  }
}

TEST(ByteRangeOfNothing, IsNeverSatisfied) {
  EXPECT_EQ(parse_byte_range("bytes=0-", 0).kind, Kind::unsatisfiable);
  EXPECT_EQ(parse_byte_range("bytes=-5", 0).kind, Kind::unsatisfiable);
}

}  // namespace
}  // namespace rouleau::service
