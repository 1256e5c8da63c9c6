#include "storage/archive/particle_slots.h"

#include <gtest/gtest.h>

#include "storage/archive_error.h"

namespace rouleau::storage {
namespace {

using Ids = std::vector<std::int64_t>;
using Slots = std::vector<int>;

TEST(ParticleSlots, FollowTheFirstFrameAndStay) {
  ParticleSlots slots(4);
  EXPECT_EQ(slots.assign(Ids{70, 50, 60}), (Slots{0, 1, 2}));
  EXPECT_EQ(slots.assign(Ids{60, 70, 50}), (Slots{2, 0, 1}));
}

TEST(ParticleSlots, ThoseLeftAreGivenAgain) {
  ParticleSlots slots(3);
  slots.assign(Ids{1, 2, 3});
  EXPECT_EQ(slots.assign(Ids{1, 3, 4}), (Slots{0, 2, 1})) << "one leaves as another comes, at full capacity";
  EXPECT_EQ(slots.assign(Ids{}), Slots{});
  EXPECT_EQ(slots.assign(Ids{9, 8, 7}), (Slots{0, 1, 2}));
}

TEST(ParticleSlots, RefuseMoreThanFitAndTwins) {
  ParticleSlots slots(2);
  EXPECT_THROW(slots.assign(Ids{1, 2, 3}), ArchiveError);
  ParticleSlots known(3);
  known.assign(Ids{1, 2});
  EXPECT_THROW(known.assign(Ids{1, 1}), ArchiveError);
  ParticleSlots fresh(3);
  EXPECT_THROW(fresh.assign(Ids{5, 5}), ArchiveError);
}

}  // namespace
}  // namespace rouleau::storage
