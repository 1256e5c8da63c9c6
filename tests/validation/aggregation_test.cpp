#include <string>

#include <gtest/gtest.h>

#include "tests/validation/scenes.h"

namespace rouleau::validation {
namespace {

// The potential has a range, the reference has none, and the bend at the edge of the contact is two links
// long.
TEST(Aggregation, TwoVesiclesTakeTheShapeOfAdhesionAgainstBending) {
  const Measurement m = scene_named("adhering_vesicles").run({16, Preset::standard});
  for (const char* adhesion : {"4", "16"}) {
    EXPECT_LE(m.error(std::string("contact_at_") + adhesion), 0.08);
    EXPECT_LE(m.error(std::string("across_at_") + adhesion), 0.04);
    EXPECT_LE(m.error(std::string("along_at_") + adhesion), 0.02);
  }
}

TEST(Aggregation, AStackHoldsInSlowShearAndIsDrawnApartInFast) {
  const Measurement m = scene_named("rouleau").run({11, Preset::standard});
  EXPECT_EQ(m.error("breaks_at_low_shear"), 0);
  EXPECT_EQ(m.error("holds_at_high_shear"), 0);
}

}  // namespace
}  // namespace rouleau::validation
