#pragma once

#include <gtest/gtest.h>

namespace rouleau {

/// Of two frames or two particle sets.
template <class Particles>
void expect_same_particles(const Particles& one, const Particles& other) {
  EXPECT_EQ(one.id, other.id);
  EXPECT_EQ(one.cell, other.cell);
  EXPECT_EQ(one.x, other.x);
  EXPECT_EQ(one.y, other.y);
  EXPECT_EQ(one.u, other.u);
  EXPECT_EQ(one.v, other.v);
  EXPECT_EQ(one.p, other.p);
}

}  // namespace rouleau
