#include "engine/particles/particle_set.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace rouleau::particles {
namespace {

constexpr double bin = 0.1;

/// Particles of random groups and places whose every field tells the id.
ParticleSet random_particles(int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> group(0, 6);
  std::uniform_real_distribution<double> place(-1, 2);
  ParticleSet set;
  for (int k = 0; k < n; ++k) {
    const int i = set.add(static_cast<Group>(group(random)), place(random), place(random), k % 3 - 1);
    const auto mark = static_cast<double>(set.id[i]);
    set.u[i] = mark + 0.1;
    set.v[i] = mark + 0.2;
    set.p[i] = mark + 0.3;
    set.du[i] = mark + 0.4;
    set.dv[i] = mark + 0.5;
    set.phi[i] = mark + 0.6;
  }
  return set;
}

TEST(ParticleSet, NewParticlesAreAtRestWithIdsOfTheirOwn) {
  ParticleSet set;
  EXPECT_EQ(set.add(Group::fluid, 1, 2), 0);
  EXPECT_EQ(set.add(Group::membrane, 3, 4, 7), 1);
  EXPECT_EQ(set.size(), 2);
  EXPECT_NE(set.id[0], set.id[1]);
  EXPECT_EQ(set.cell[0], -1);
  EXPECT_EQ(set.cell[1], 7);
  EXPECT_EQ(set.u[1], 0);
  EXPECT_EQ(set.phi[1], 0);
}

TEST(SortParticles, GroupsStandTogetherInTheirOrder) {
  ParticleSet set = random_particles(500, 1);
  std::map<Group, int> counts;
  for (const Group g : set.group) ++counts[g];
  sort_particles(set, bin);
  int at = 0;
  for (const Group g :
       {Group::membrane, Group::fluid, Group::outlet, Group::inlet, Group::wall, Group::ghost}) {
    ASSERT_EQ(set.first(g), at);
    for (int k = 0; k < counts[g]; ++k) ASSERT_EQ(set.group[at++], g);
  }
  EXPECT_EQ(set.first(Group::dead), at);
  EXPECT_EQ(set.size(), at);
  EXPECT_EQ(set.membrane_end(), counts[Group::membrane]);
  EXPECT_EQ(set.active_end(), set.first(Group::outlet));
  EXPECT_EQ(set.velocity_end(), set.first(Group::ghost));
}

TEST(SortParticles, DropsTheDeadAndNobodyElse) {
  ParticleSet set = random_particles(300, 2);
  std::set<std::int64_t> alive;
  for (int i = 0; i < set.size(); ++i) {
    if (set.group[i] != Group::dead) alive.insert(set.id[i]);
  }
  ASSERT_LT(alive.size(), 300u);
  sort_particles(set, bin);
  EXPECT_EQ(std::set(set.id.begin(), set.id.end()), alive);
  EXPECT_EQ(set.id.size(), alive.size());
}

TEST(SortParticles, EveryFieldGoesWithItsParticle) {
  ParticleSet set = random_particles(400, 3);
  const ParticleSet before = set;
  sort_particles(set, bin);
  bool moved = false;
  for (int i = 0; i < set.size(); ++i) {
    const auto k = static_cast<int>(set.id[i]);  // ids count up from 0
    moved = moved || k != i;
    const auto mark = static_cast<double>(set.id[i]);
    ASSERT_EQ(set.x[i], before.x[k]);
    ASSERT_EQ(set.y[i], before.y[k]);
    ASSERT_EQ(set.cell[i], before.cell[k]);
    ASSERT_EQ(set.group[i], before.group[k]);
    ASSERT_EQ(set.u[i], mark + 0.1);
    ASSERT_EQ(set.v[i], mark + 0.2);
    ASSERT_EQ(set.p[i], mark + 0.3);
    ASSERT_EQ(set.du[i], mark + 0.4);
    ASSERT_EQ(set.dv[i], mark + 0.5);
    ASSERT_EQ(set.phi[i], mark + 0.6);
  }
  EXPECT_TRUE(moved);
}

TEST(SortParticles, MembranesWallsAndGhostsKeepTheirOrder) {
  ParticleSet set = random_particles(400, 4);
  sort_particles(set, bin);
  for (const Group g : {Group::membrane, Group::wall, Group::ghost}) {
    const int end = set.first(static_cast<Group>(static_cast<int>(g) + 1));
    ASSERT_GT(end - set.first(g), 10);
    ASSERT_TRUE(std::is_sorted(set.id.begin() + set.first(g), set.id.begin() + end));
  }
}

TEST(SortParticles, FluidIsFiledByBinsColumnByColumn) {
  ParticleSet set = random_particles(600, 5);
  sort_particles(set, bin);
  const auto bin_of = [&](int i) {
    return std::pair{std::floor(set.x[i] / bin), std::floor(set.y[i] / bin)};
  };
  for (int i = set.membrane_end() + 1; i < set.active_end(); ++i) ASSERT_LE(bin_of(i - 1), bin_of(i));
}

TEST(SortParticles, IsTheSameWhenDoneTwice) {
  ParticleSet set = random_particles(300, 6);
  sort_particles(set, bin);
  const auto ids = set.id;
  sort_particles(set, bin);
  EXPECT_EQ(set.id, ids);
}

TEST(SortParticles, IdsAreNeverUsedAgain) {
  ParticleSet set = random_particles(50, 7);
  for (Group& g : set.group) g = Group::dead;
  sort_particles(set, bin);
  EXPECT_EQ(set.size(), 0);
  const int i = set.add(Group::fluid, 0, 0);
  EXPECT_EQ(set.id[i], 50);
}

TEST(SortParticles, PlacesOutOfAllBoundsAreKept) {
  ParticleSet set;
  for (const double x : {0.5, 1e300, -1e300, std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::quiet_NaN(), 0.1}) {
    set.add(Group::fluid, x, 0.5);
    set.add(Group::fluid, 0.5, x);
  }
  sort_particles(set, bin);
  EXPECT_EQ(set.size(), 12);
  EXPECT_EQ(set.active_end(), 12);
}

}  // namespace
}  // namespace rouleau::particles
