#include "engine/cells/morse.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "tests/unit/engine/cells/ring_pair.h"

namespace rouleau::cells {
namespace {

using std::numbers::pi;

constexpr MorseLaw law{2.0, 0.25, 12.0};

struct Adhesion {
  double energy;
  Nodes force;
  std::vector<Contact> contacts;
};

Adhesion adhesion_of(const RingPair& pair) {
  const std::size_t n = pair.nodes.x.size();
  Adhesion found{0, {std::vector<double>(n, 0.0), std::vector<double>(n, 0.0)}, {}};
  const LinkBoxes a(pair.first()), b(pair.second());
  const auto split = static_cast<int>(pair.split);
  append_adhesion(a, 0, b, split, law.reach(), found.contacts);
  add_adhesion_forces(found.contacts, a.ring(), 0, law, found.force.x, found.force.y);
  std::vector<Contact> other_way;
  append_adhesion(b, split, a, 0, law.reach(), other_way);
  add_adhesion_forces(other_way, b.ring(), split, law, found.force.x, found.force.y);
  found.contacts.insert(found.contacts.end(), other_way.begin(), other_way.end());
  found.energy = contact_energy(found.contacts, law);
  return found;
}

double largest(const Nodes& force) {
  double most = 0;
  for (std::size_t i = 0; i < force.x.size(); ++i) most = std::max(most, std::hypot(force.x[i], force.y[i]));
  return most;
}

TEST(Morse, ForcesAreMinusTheGradientOfTheEnergy) {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    RingPair pair = neighbours(seed, 0.02 + 0.005 * seed);
    const Nodes force = adhesion_of(pair).force;
    const double scale = largest(force);
    ASSERT_GT(scale, 0.0) << "seed " << seed;
    const auto slope = [&](double& coordinate) {
      const double step = 1e-7, middle = coordinate;
      coordinate = middle + step;
      const double above = adhesion_of(pair).energy;
      coordinate = middle - step;
      const double below = adhesion_of(pair).energy;
      coordinate = middle;
      return (above - below) / (2.0 * step);
    };
    for (std::size_t i = 0; i < pair.nodes.x.size(); ++i) {
      ASSERT_NEAR(force.x[i], -slope(pair.nodes.x[i]), 1e-6 * scale) << "seed " << seed << ", node " << i;
      ASSERT_NEAR(force.y[i], -slope(pair.nodes.y[i]), 1e-6 * scale) << "seed " << seed << ", node " << i;
    }
  }
}

TEST(Morse, WhatOneMembraneGivesTheOtherReceives) {
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    const RingPair pair = neighbours(seed, 0.02 + 0.005 * seed);
    const Nodes force = adhesion_of(pair).force;
    double fx[2] = {}, fy[2] = {}, torque = 0, scale = 0;
    for (std::size_t i = 0; i < force.x.size(); ++i) {
      const int ring = i < pair.split ? 0 : 1;
      fx[ring] += force.x[i];
      fy[ring] += force.y[i];
      torque += pair.nodes.x[i] * force.y[i] - pair.nodes.y[i] * force.x[i];
      scale += std::hypot(force.x[i], force.y[i]);
    }
    EXPECT_NEAR(fx[0], -fx[1], 1e-13 * scale);
    EXPECT_NEAR(fy[0], -fy[1], 1e-13 * scale);
    EXPECT_NEAR(torque, 0, 1e-11 * scale);
  }
}

/// The energy that two bands have for each length by which both are longer.
double energy_per_length(double gap, double link) {
  const auto energy = [&](int n) {
    return adhesion_of({band(0, n, link), band(2 + gap, n, link), 0, 0}).energy;
  };
  const int n = static_cast<int>(std::lround(4 / link));
  return (energy(2 * n) - energy(n)) / (n * link);
}

TEST(Morse, OfFlatMembranesIsThePotentialForEachLengthWhateverTheSpacing) {
  for (const double gap : {0.1, 0.25, 0.3, 0.45}) {
    const double e = std::exp(law.scaling * (law.distance - gap));
    for (const double link : {0.5, 0.25, 0.1}) {
      EXPECT_NEAR(energy_per_length(gap, link), law.depth * (e * e - 2 * e), 1e-12) << gap << ' ' << link;
    }
  }
}

TEST(Morse, FlatMembranesAreInBalanceAtTheZeroForceDistance) {
  const auto lift = [](double gap) {
    const RingPair pair(band(0, 30), band(2 + gap, 30), 0, 0);
    const Nodes force = adhesion_of(pair).force;
    return std::accumulate(force.y.begin() + static_cast<long>(pair.split), force.y.end(), 0.0);
  };
  const double scale = lift(0.2);
  EXPECT_GT(scale, 0);
  EXPECT_NEAR(lift(law.distance), 0, 1e-12 * scale);
  EXPECT_LT(lift(0.3), 0);
}

/// Of a plane at an angle to another: the integral of the potential over the gaps along it.
TEST(Morse, OfAWedgeIsTheIntegralOfThePotential) {
  const double angle = 0.05, nearest = 0.2, link = 0.0125;
  Nodes tilted = band(0, 300, link);
  for (std::size_t i = 0; i < tilted.x.size(); ++i) {
    const double x = tilted.x[i], y = tilted.y[i];
    tilted.x[i] = x * std::cos(angle) - y * std::sin(angle);
    tilted.y[i] = x * std::sin(angle) + y * std::cos(angle);
  }
  const RingPair pair(tilted, band(-2 - nearest, 600, link), 0, 0);
  std::vector<Contact> contacts;
  append_adhesion(LinkBoxes(pair.first()), 0, LinkBoxes(pair.second()), 0, law.reach(), contacts);
  // The nodes from 20 to 260, where nothing is faded out; half of what the pair would have.
  double energy = 0;
  for (const Contact& contact : contacts) {
    if (contact.point >= 20 && contact.point <= 260) {
      const double share = contact.point == 20 || contact.point == 260 ? 0.5 : 1;
      energy += share * contact.weight * law.energy(contact.gap);
    }
  }
  const auto primitive = [&](double gap) {
    const double e = std::exp(law.scaling * (law.distance - gap));
    return law.depth / law.scaling * (2 * e - e * e / 2) / std::sin(angle);
  };
  const double from = nearest + 20 * link * std::sin(angle), to = nearest + 260 * link * std::sin(angle);
  ASSERT_LT(to, law.distance + 3 / law.scaling);
  const double exact = (primitive(to) - primitive(from)) / 2;
  EXPECT_NEAR(energy, exact, 1e-4 * std::abs(exact));
}

Nodes ellipse(int n) {
  Nodes nodes;
  for (int i = 0; i < n; ++i) {
    nodes.x.push_back(1.5 * std::cos(2 * pi * (i + 0.3) / n));
    nodes.y.push_back(3 * std::sin(2 * pi * (i + 0.3) / n));
  }
  return nodes;
}

TEST(Morse, OfCurvedMembranesConvergesWithTheSquareOfTheSpacing) {
  const auto energy = [](int n) { return adhesion_of({ellipse(n), ellipse(n), 3.2, 0.4}).energy; };
  const double exact = energy(1600);
  EXPECT_LT(std::abs(energy(50) / exact - 1), 0.05);
  EXPECT_LT(std::abs(energy(200) - exact), std::abs(energy(50) - exact) / 10);
}

TEST(Morse, IsNothingBeyondItsReach) {
  EXPECT_TRUE(adhesion_of(neighbours(1, 1.001 * law.reach())).contacts.empty());
  EXPECT_FALSE(adhesion_of(neighbours(1, 0.999 * law.reach())).contacts.empty());
}

TEST(MorseLaw, ForceAndSlopeAreItsDerivativesUpToItsReach) {
  const double step = 1e-6;
  for (const double gap : {0.05, 0.25, 0.3, 0.45, 0.51, 0.55, 0.62, 0.66}) {
    EXPECT_NEAR(law.force(gap), -(law.energy(gap + step) - law.energy(gap - step)) / (2 * step), 1e-6) << gap;
    EXPECT_NEAR(law.slope(gap), -(law.force(gap + step) - law.force(gap - step)) / (2 * step), 1e-4) << gap;
  }
  EXPECT_EQ(law.energy(law.distance), -law.depth);
  EXPECT_NEAR(law.slope(law.distance), 2 * law.scaling * law.scaling * law.depth, 1e-9);
  EXPECT_EQ(law.energy(law.reach() + 1e-12), 0);
  EXPECT_NEAR(law.force(law.reach() - 1e-9), 0, 1e-9);
  EXPECT_NEAR(law.slope(law.reach() - 1e-9), 0, 1e-5);
}

}  // namespace
}  // namespace rouleau::cells
