#include "engine/case/key_checks.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

namespace rouleau {
namespace {

using nlohmann::json;

bool sound(const json& value, const Key& key) {
  Faults faults;
  sound_part(value, key, "/value", faults);
  return faults.clean("");
}

TEST(KeyChecks, AnIntegerIsAWholeNumberInItsRange) {
  const Key key = {
      .name = "count", .kind = Kind::integer, .description = "", .range = {.least = 0, .most = 10}};
  for (const json& value : {json(0), json(3), json(10), json(3.0)}) EXPECT_TRUE(sound(value, key)) << value;
  for (const json& value : {json(3.9), json(-1), json(11), json("3"), json(true), json(nullptr)}) {
    EXPECT_FALSE(sound(value, key)) << value;
  }
  EXPECT_FALSE(sound(std::numeric_limits<std::uint64_t>::max(), key));
  EXPECT_FALSE(sound(std::numeric_limits<std::int64_t>::min(), key));
}

TEST(KeyChecks, ANumberKeepsItsBounds) {
  const Key open = {.name = "x",
                    .description = "",
                    .range = {.least = 0, .most = 1, .above_least = true, .below_most = true}};
  const Key closed = {.name = "x", .description = "", .range = {.least = 0, .most = 1}};
  const Key or_zero = {.name = "x", .description = "", .range = {.least = 0.5, .most = 1, .or_zero = true}};
  for (const double bound : {0.0, 1.0}) {
    EXPECT_FALSE(sound(bound, open));
    EXPECT_TRUE(sound(bound, closed));
    EXPECT_TRUE(sound(bound, or_zero));
  }
  EXPECT_TRUE(sound(std::nextafter(1.0, 0.0), open));
  EXPECT_FALSE(sound(std::nextafter(1.0, 2.0), closed));
  EXPECT_FALSE(sound(0.25, or_zero));
  EXPECT_FALSE(sound(std::numeric_limits<double>::quiet_NaN(), closed));
}

TEST(KeyChecks, LeavesOutWhatIsNotSound) {
  const Key object = {.name = "object",
                      .kind = Kind::object,
                      .description = "",
                      .members = {{.name = "a", .description = ""}, {.name = "b", .description = ""}}};
  Faults faults;
  EXPECT_EQ(sound_part({{"a", 1}, {"b", "2"}, {"c", 3}}, object, "", faults), json({{"a", 1}}));
  EXPECT_FALSE(faults.clean("/b"));
  EXPECT_FALSE(faults.clean("/c"));
  EXPECT_TRUE(faults.clean("/a"));

  const Key list = {
      .name = "list", .kind = Kind::list, .description = "", .most_entries = 3, .members = object.members};
  Faults more;
  EXPECT_EQ(sound_part({{{"a", 1}}, 7, {{"b", 2}}}, list, "", more),
            json({{{"a", 1}}, json::object(), {{"b", 2}}}));
}

TEST(Faults, CleanTellsNeighboursApart) {
  Faults faults;
  faults.add("/cells/10/x", "found nothing");
  EXPECT_FALSE(faults.clean("/cells/10"));
  EXPECT_FALSE(faults.clean("/cells"));
  EXPECT_TRUE(faults.clean("/cells/1"));
  EXPECT_TRUE(faults.clean("/cells/10/x/y"));
  EXPECT_TRUE(Faults{}.clean(""));
  EXPECT_NO_THROW(Faults{}.raise());
}

TEST(Names, AreLowerSnakeCase) {
  for (const char* name : {"a", "bending", "viscosity_implicit", "a1_2b"})
    EXPECT_TRUE(is_lower_snake_case(name)) << name;
  for (const char* name : {"", "_a", "a_", "a__b", "1a", "A", "a-b", "a b", "ä"})
    EXPECT_FALSE(is_lower_snake_case(name)) << name;
}

}  // namespace
}  // namespace rouleau
