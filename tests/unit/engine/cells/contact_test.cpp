#include "engine/cells/contact.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/unit/engine/cells/ring_pair.h"

namespace rouleau::cells {
namespace {

using std::numbers::pi;

constexpr ContactLaw law{2.0, 0.3};

std::vector<Contact> contacts_of(const RingPair& pair, double range = law.range) {
  const LinkBoxes a(pair.first()), b(pair.second());
  const auto offset = static_cast<int>(pair.split);
  std::vector<Contact> found;
  append_contacts(a, 0, b, offset, range, -1, found);
  append_contacts(b, offset, a, 0, range, -1, found);
  return found;
}

Nodes forces(const std::vector<Contact>& contacts, std::size_t nodes) {
  Nodes force{std::vector<double>(nodes, 0.0), std::vector<double>(nodes, 0.0)};
  add_contact_forces(contacts, law, force.x, force.y);
  return force;
}

TEST(Contact, ForcesAreMinusTheGradientOfTheEnergy) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    RingPair pair = neighbours(seed, 0.02 + 0.001 * seed);
    const Nodes force = forces(contacts_of(pair), pair.nodes.x.size());
    double scale = 0;
    for (std::size_t i = 0; i < force.x.size(); ++i) {
      scale = std::max(scale, std::hypot(force.x[i], force.y[i]));
    }
    ASSERT_GT(scale, 0.0) << "seed " << seed;
    const auto slope = [&](double& coordinate) {
      const double step = 1e-7, middle = coordinate;
      coordinate = middle + step;
      const double above = contact_energy(contacts_of(pair), law);
      coordinate = middle - step;
      const double below = contact_energy(contacts_of(pair), law);
      coordinate = middle;
      return (above - below) / (2.0 * step);
    };
    for (std::size_t i = 0; i < pair.nodes.x.size(); ++i) {
      ASSERT_NEAR(force.x[i], -slope(pair.nodes.x[i]), 1e-6 * scale) << "seed " << seed << ", node " << i;
      ASSERT_NEAR(force.y[i], -slope(pair.nodes.y[i]), 1e-6 * scale) << "seed " << seed << ", node " << i;
    }
  }
}

TEST(Contact, WhatOneMembraneGivesTheOtherReceives) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    const RingPair pair = neighbours(seed, 0.1);
    const Nodes force = forces(contacts_of(pair), pair.nodes.x.size());
    double fx[2] = {}, fy[2] = {}, torque[2] = {}, scale = 0;
    for (std::size_t i = 0; i < force.x.size(); ++i) {
      const int ring = i < pair.split ? 0 : 1;
      fx[ring] += force.x[i];
      fy[ring] += force.y[i];
      torque[ring] += pair.nodes.x[i] * force.y[i] - pair.nodes.y[i] * force.x[i];
      scale += std::hypot(force.x[i], force.y[i]);
    }
    EXPECT_LT(fx[0], 0);
    EXPECT_NEAR(fx[0], -fx[1], 1e-13 * scale);
    EXPECT_NEAR(fy[0], -fy[1], 1e-13 * scale);
    EXPECT_NEAR(torque[0], -torque[1], 1e-11 * scale);
  }
}

TEST(Contact, IsNothingBeyondTheRange) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    EXPECT_TRUE(contacts_of(neighbours(seed, law.range * 1.001)).empty());
    EXPECT_FALSE(contacts_of(neighbours(seed, law.range * 0.999)).empty());
  }
}

/// A link's jump of force, where its end takes over from its middle or a contact from another, shows as a
/// change that does not shrink with the step.
TEST(Contact, ForcesAreContinuousAsOneMembraneSlidesPastTheOther) {
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    RingPair pair = neighbours(seed, 0.1);
    const auto largest_change = [&](int steps) {
      RingPair moving = pair;
      Nodes last = forces(contacts_of(moving), moving.nodes.x.size());
      double largest = 0;
      for (int k = 0; k < steps; ++k) {
        for (std::size_t i = moving.split; i < moving.nodes.x.size(); ++i) moving.nodes.y[i] += 0.5 / steps;
        const Nodes now = forces(contacts_of(moving), moving.nodes.x.size());
        for (std::size_t i = 0; i < now.x.size(); ++i) {
          largest = std::max(largest, std::hypot(now.x[i] - last.x[i], now.y[i] - last.y[i]));
        }
        last = now;
      }
      return largest;
    };
    EXPECT_LT(largest_change(16000), 0.2 * largest_change(2000)) << "seed " << seed;
  }
}

/// What it would be from node to node depends on where the nodes are.
TEST(Contact, OfStraightMembranesIsThatOfTheirDistance) {
  const double gap = 0.12;
  for (const double shift : {0.0, 0.1, 0.25, 0.4}) {
    const RingPair pair(band(0, 20), band(2 + gap, 10), 2 + shift, 0);
    const Nodes force = forces(contacts_of(pair), pair.nodes.x.size());
    double lift = 0, drag = 0;
    for (std::size_t i = pair.split; i < force.x.size(); ++i) {
      lift += force.y[i];
      drag += std::abs(force.x[i]);
    }
    // Its eleven nodes, and those of the lower one that face it.
    const int facing = shift == 0.0 ? 11 : 10;
    EXPECT_NEAR(lift, (11 + facing) * law.force(gap), 0.6 * law.force(gap)) << shift;
    EXPECT_LT(drag, shift == 0.0 ? 1e-12 : 0.6 * law.force(gap)) << shift;
  }
}

TEST(Contact, StiffnessIsTheSlopeOfTheForceAlongTheNormal) {
  const RingPair pair = neighbours(3, 0.1);
  const auto contacts = contacts_of(pair);
  std::vector<Stiffness> terms;
  append_contact_stiffness(contacts, law, terms);
  ASSERT_FALSE(terms.empty());
  for (const Stiffness& term : terms) {
    EXPECT_GT(term.k, 0);
    EXPECT_NEAR(term.g[0] + term.g[2] + term.g[4], 0, 1e-14);
    EXPECT_NEAR(term.g[1] + term.g[3] + term.g[5], 0, 1e-14);
  }
  for (const double gap : {0.001, 0.02, 0.1, 0.2, 0.29, 0.31}) {
    EXPECT_NEAR((law.force(gap - 1e-7) - law.force(gap + 1e-7)) / 2e-7, gap < 0.015 ? 0 : law.slope(gap),
                1e-5 * (1 + law.slope(gap)));
  }
}

TEST(Contact, OfAMembraneWithItselfLeavesItsNeighbourhoodOut) {
  // A flat ellipse: its flanks are 0.2 apart in the middle, its tips sharp.
  Nodes nodes;
  for (int i = 0; i < 80; ++i) {
    nodes.x.push_back(3 * std::cos(2 * pi * i / 80));
    nodes.y.push_back(0.1 * std::sin(2 * pi * i / 80));
  }
  const LinkBoxes boxes(nodes.ring());
  std::vector<Contact> contacts;
  append_contacts(boxes, 0, boxes, 0, 0.3, 6, contacts);
  ASSERT_FALSE(contacts.empty());
  for (const Contact& contact : contacts) {
    EXPECT_GT(
        along_ring(static_cast<std::size_t>(contact.point), static_cast<std::size_t>(contact.link[0]), 80),
        6u);
  }
  const Nodes force = forces(contacts, 80);
  EXPECT_GT(force.y[20], 0);
  EXPECT_LT(force.y[60], 0);
  double fx = 0, fy = 0, torque = 0;
  for (std::size_t i = 0; i < 80; ++i) {
    fx += force.x[i];
    fy += force.y[i];
    torque += nodes.x[i] * force.y[i] - nodes.y[i] * force.x[i];
  }
  EXPECT_NEAR(fx, 0, 1e-9);
  EXPECT_NEAR(fy, 0, 1e-9);
  EXPECT_NEAR(torque, 0, 1e-9);
}

/// A wide plate whose corners are far away, above the top of a disc that lies between two of its nodes.
TEST(Contact, ADiscPushesTheLinkThatItIsUnder) {
  const Nodes nodes = band(0, 20);
  const LinkBoxes boxes(nodes.ring());
  std::vector<Contact> contacts;
  append_disc_contacts(boxes, 0, {5.1, -0.15}, 0.05, 0.3, contacts);
  const Nodes force = forces(contacts, nodes.x.size());
  EXPECT_NEAR(force.y[10] + force.y[11], law.force(0.1), 1e-12);
  EXPECT_NEAR(force.y[11] / law.force(0.1), 0.2, 1e-12);
}

TEST(ContactLaw, GoesOnSmoothlyWhereItStartsAndWhereItStays) {
  for (const double gap : {0.3, 0.015}) {
    EXPECT_NEAR(law.force(gap - 1e-10), law.force(gap + 1e-10), 1e-6);
    EXPECT_NEAR(law.energy(gap - 1e-10), law.energy(gap + 1e-10), 1e-8);
  }
  EXPECT_EQ(law.force(-1), law.force(0));
  EXPECT_GT(law.force(0), 15 * law.strength);
  EXPECT_NEAR(law.force(0.3 * 0.382), law.strength, 0.01 * law.strength);
}

}  // namespace
}  // namespace rouleau::cells
