#include "service/log.h"

#include <gtest/gtest.h>

namespace rouleau::service {
namespace {

TEST(LogLine, HasKeysAndValues) {
  EXPECT_EQ(log::format("job accepted", {{"job", "01a2-b"}, {"name", "8 d0"}, {"empty", ""}}),
            "event=\"job accepted\" job=01a2-b name=\"8 d0\" empty=\"\"");
}

TEST(LogLine, CannotBeForged) {
  EXPECT_EQ(log::format("x", {{"name", "a\nlevel=error \"b\"\x1b[31m\xff"}}),
            "event=x name=\"a\\nlevel=error \\\"b\\\"\\u001b[31m\\ufffd\"");
}

TEST(LogLine, CanBeJson) {
  EXPECT_EQ(log::format_members("a \"b\"", {{"name", "x\n\xff"}, {"empty", ""}}),
            R"("event":"a \"b\"","name":"x\n\ufffd","empty":"")");
}

}  // namespace
}  // namespace rouleau::service
