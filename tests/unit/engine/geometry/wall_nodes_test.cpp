#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/engine/geometry/vessels.h"

namespace rouleau::geometry {
namespace {

Case periodic_vessel(std::vector<Thrombus> thrombi) {
  Case scene = straight_vessel(3, 1, std::move(thrombi));
  scene.vessel.ends = Ends::periodic;
  return scene;
}

class NodesOf : public testing::TestWithParam<Case> {
 protected:
  const Outline outline_ = outline_of(GetParam());
};

TEST_P(NodesOf, LieOnTheWallWithUnitNormalsIntoTheFluid) {
  for (const WallNode& node : outline_.wall_nodes(0.043, 0.3)) {
    ASSERT_NEAR(outline_.distance(node.x, node.y).value, 0, 1e-12) << node.x << ", " << node.y;
    ASSERT_NEAR(std::hypot(node.nx, node.ny), 1, 1e-12);
    // Half of it suffices for the feet of thrombi and the corners of a box, where both walls are as near.
    ASSERT_GT(outline_.distance(node.x + 1e-3 * node.nx, node.y + 1e-3 * node.ny).value, 5e-4);
  }
}

TEST_P(NodesOf, StandForTheWholeWall) {
  const int open_ends = 2 * static_cast<int>(std::ranges::count(outline_.walls(), false, &WallChain::loop));
  for (const double spacing : {0.043, 0.02}) {
    double sum = 0;
    for (const WallNode& node : outline_.wall_nodes(spacing, 0.3)) sum += node.length;
    EXPECT_NEAR(sum, wall_length(outline_) + open_ends * 0.3, 1e-12);
  }
}

TEST_P(NodesOf, AreSpacedAsNearToTheSpacingAsCanBe) {
  const double spacing = 0.043;
  const auto nodes = outline_.wall_nodes(spacing, 0);
  std::size_t first = 0;
  for (const WallChain& chain : outline_.walls()) {
    for (const WallPiece& piece : chain.pieces) {
      const double length = piece.radius > 0
                                ? std::acos(-1) * piece.radius
                                : std::hypot(piece.to[0] - piece.from[0], piece.to[1] - piece.from[1]);
      const auto steps = static_cast<std::size_t>(std::lround(length / spacing));
      EXPECT_NEAR(length / (static_cast<double>(steps) * spacing), 1, 0.5 / static_cast<double>(steps));
      for (std::size_t k = 1; k < steps; ++k) {
        ASSERT_NEAR(nodes[first + k].length, length / static_cast<double>(steps), 1e-12);
      }
      first += steps;
    }
    if (!chain.loop) ++first;
  }
  EXPECT_EQ(first, nodes.size());
}

TEST_P(NodesOf, AreNowhereDoubled) {
  const auto nodes = outline_.wall_nodes(0.043, 0.3);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      double dx = nodes[i].x - nodes[k].x;
      if (outline_.period_x() > 0) dx = std::remainder(dx, outline_.period_x());
      ASSERT_GT(std::hypot(dx, nodes[i].y - nodes[k].y), 0.02) << nodes[i].x << ", " << nodes[i].y;
    }
  }
}

TEST_P(NodesOf, HaveGhostsBehindTheWallsAndApart) {
  const double spacing = 0.05;
  const auto nodes = outline_.wall_nodes(spacing, 0.3);
  const auto ghosts = outline_.ghosts(nodes, 3, spacing);
  EXPECT_GT(ghosts.size(), 2 * nodes.size());
  for (std::size_t i = 0; i < ghosts.size(); ++i) {
    ASSERT_LE(outline_.distance(ghosts[i][0], ghosts[i][1]).value, -0.499 * spacing);
    for (std::size_t k = 0; k < i; ++k) {
      ASSERT_GT(std::hypot(ghosts[i][0] - ghosts[k][0], ghosts[i][1] - ghosts[k][1]), 0.499 * spacing);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Vessels, NodesOf,
                         testing::Values(straight_vessel(4, 1, {{Wall::lower, 1.1, 0.35}}),
                                         periodic_vessel({}),
                                         periodic_vessel({{Wall::lower, 0.1, 0.3}, {Wall::lower, 2.0, 0.2}}),
                                         box(2, 1, Ends::closed), bifurcation(), uneven_bifurcation()),
                         [](const auto& vessel) { return std::to_string(vessel.index); });

TEST(WallNodes, OfAPeriodicVesselGoOnEvenlyAcrossTheSeam) {
  const auto nodes = outline_of(periodic_vessel({})).wall_nodes(0.1, 0.5);
  ASSERT_EQ(nodes.size(), 60u);
  for (std::size_t k = 0; k < 30; ++k) {
    EXPECT_NEAR(nodes[k].x, 0.1 * static_cast<double>(k), 1e-12);
    EXPECT_NEAR(nodes[k].length, 0.1, 1e-12);
    EXPECT_EQ(nodes[k].ny, 1);
  }
}

TEST(WallNodes, OfAPeriodicVesselLieWithinOnePeriod) {
  for (const WallNode& node : outline_of(periodic_vessel({{Wall::lower, 0.1, 0.3}})).wall_nodes(0.05, 0)) {
    EXPECT_GE(node.x, -1e-6);
    EXPECT_LT(node.x, 3);
  }
}

TEST(WallNodes, MoveAsTheirWallDoes) {
  Case scene = periodic_vessel({});
  scene.vessel.wall_velocity.lower = -0.5;
  scene.vessel.wall_velocity.upper = 2;
  for (const WallNode& node : Outline(scene, 1, 0.5).wall_nodes(0.1, 0)) {
    EXPECT_DOUBLE_EQ(node.u, node.y == 0 ? -1 : 4);
    EXPECT_NEAR(node.v, 0, 1e-15);
  }
}

TEST(WallNodes, InTheCornersOfADrivenCavityAreAtRest) {
  Case scene = box(1, 1, Ends::closed);
  scene.vessel.wall_velocity = {.lower = 0, .upper = 1, .left = 0, .right = 0.25};
  int corners = 0;
  for (const WallNode& node : outline_of(scene).wall_nodes(0.1, 0)) {
    const bool beside = node.x == 0 || node.x == 1, below = node.y == 0, above = node.y == 1;
    if (beside && (below || above)) {
      ++corners;
      EXPECT_EQ(node.u, 0);
      EXPECT_EQ(node.v, 0);
      EXPECT_NEAR(std::abs(node.nx), std::sqrt(0.5), 1e-15);
    } else {
      EXPECT_NEAR(node.u, above ? 1 : 0, 1e-15);
      EXPECT_NEAR(node.v, node.x == 1 ? 0.25 : 0, 1e-15);
    }
  }
  EXPECT_EQ(corners, 4);
}

TEST(WallNodes, KnowThatTheyAreUpstreamOfTheInlet) {
  for (const Case& scene : {straight_vessel(4, 1), bifurcation()}) {
    const auto nodes = outline_of(scene).wall_nodes(0.05, 0.4);
    EXPECT_EQ(std::ranges::count(nodes, true, &WallNode::beyond_inlet), 16);
    for (const WallNode& node : nodes) EXPECT_EQ(node.beyond_inlet, node.x < -1e-9);
  }
}

}  // namespace
}  // namespace rouleau::geometry
