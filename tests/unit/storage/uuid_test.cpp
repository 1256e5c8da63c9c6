#include "storage/uuid.h"

#include <gtest/gtest.h>

namespace rouleau::storage {
namespace {

TEST(Uuid, CarriesTheTimeVersionAndVariant) {
  UuidSource ids;
  const std::string id = ids.next(0x017F22E279B0);  // the example of RFC 9562, A.6
  EXPECT_TRUE(is_uuid(id)) << id;
  EXPECT_EQ(id.substr(0, 13), "017f22e2-79b0");
  EXPECT_EQ(id[14], '7');
  EXPECT_NE(std::string("89ab").find(id[19]), std::string::npos) << id;
}

TEST(Uuid, RisesWithinAMillisecondAndAgainstTheClock) {
  UuidSource ids;
  std::string last;
  for (int i = 0; i < 10'000; ++i) {
    const std::string id = ids.next(1000 - i / 3000);
    ASSERT_GT(id, last);
    last = id;
  }
}

TEST(Uuid, RisesThroughEveryCarry) {
  UuidSource ids;
  for (const char* id : {"00000000-03e8-7fff-bfff-ffffffffffff", "00000000-03e8-7abc-bfff-ffffffffffff",
                         "00000000-ffff-7fff-bfff-ffffffffffff"}) {
    ids.start_after(id);
    const std::string next = ids.next(0);
    EXPECT_GT(next, id);
    EXPECT_TRUE(is_uuid(next)) << next;
    EXPECT_EQ(next[14], '7');
  }
}

TEST(Uuid, TwoSourcesDiffer) {
  UuidSource a, b;
  EXPECT_NE(a.next(1000), b.next(1000));
}

TEST(Uuid, KnowsWhatIsNone) {
  for (const char* text :
       {"", "x", "017f22e2-79b0-7cc3-98c4-dc0c0c07398", "017F22E2-79B0-7CC3-98C4-DC0C0C07398F",
        "017f22e2079b0-7cc3-98c4-dc0c0c07398f", "017f22e2-79b0-7cc3-98c4-dc0c0c07398g"}) {
    EXPECT_FALSE(is_uuid(text)) << text;
  }
  UuidSource ids;
  ids.start_after("nonsense");
  EXPECT_TRUE(is_uuid(ids.next(5)));
}

}  // namespace
}  // namespace rouleau::storage
