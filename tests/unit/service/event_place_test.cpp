#include "service/api/event_place.h"

#include <gtest/gtest.h>

#include "engine/simulation/run.h"

namespace rouleau::service {
namespace {

TEST(EventPlace, IsReadAsItWasWritten) {
  for (const EventPlace& place : {EventPlace{}, EventPlace{17, {}}, EventPlace{17, 1795318393042}}) {
    EXPECT_EQ(parse_event_id(to_event_id(place)), place) << to_event_id(place);
  }
}

TEST(EventPlace, IsTheStartWhereItIsNoneOfOurs) {
  const std::string version = engine_version();
  for (const std::string& id :
       {std::string(), std::string("5"), "@" + version, "-5@" + version, "5@" + version + "x",
        "5x@" + version, std::string("5@0.0.0"), "99999999999999999999999@" + version}) {
    EXPECT_EQ(parse_event_id(id), EventPlace{}) << id;
  }
}

}  // namespace
}  // namespace rouleau::service
