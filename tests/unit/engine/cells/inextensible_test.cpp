#include "engine/cells/inextensible.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "engine/cells/link.h"
#include "engine/cells/stretch.h"
#include "tests/unit/engine/cells/random_ring.h"

namespace rouleau::cells {
namespace {

constexpr double modulus = 50;

Material material() {
  return {3.0, 0.7, 0.5};
}

/// A ring that was held as it was at first, and has moved a little since.
struct Moved {
  explicit Moved(std::uint32_t seed) : nodes(random_ring(seed)), held(hold_links(nodes.ring(), material())) {
    const std::size_t n = nodes.x.size();
    u = random_vector(seed + 1, n);
    v = random_vector(seed + 2, n);
    for (std::size_t i = 0; i < n; ++i) {
      nodes.x[i] += 0.01 * u[i];
      nodes.y[i] += 0.01 * v[i];
    }
  }

  Nodes forces() const {
    Nodes force{std::vector<double>(u.size(), 0.0), std::vector<double>(u.size(), 0.0)};
    add_held_forces(nodes.ring(), held, modulus, force.x, force.y);
    return force;
  }

  Nodes nodes;
  HeldLinks held;
  std::vector<double> u, v;
};

TEST(HeldLinks, AreHeldByTheTensionOfTheirSprings) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Nodes nodes = random_ring(seed);
    const std::size_t n = nodes.x.size();
    const HeldLinks held = hold_links(nodes.ring(), material());
    EXPECT_LT(greatest_length_error(nodes.ring(), held), 1e-14);
    std::vector<double> x(n, 0.0), y(n, 0.0), as_x(n, 0.0), as_y(n, 0.0);
    add_held_forces(nodes.ring(), held, modulus, x, y);
    add_stretch_forces(nodes.ring(), material(), as_x, as_y);
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_NEAR(x[i], as_x[i], 1e-12);
      EXPECT_NEAR(y[i], as_y[i], 1e-12);
    }
  }
}

/// The power of the forces is that of the tensions on the links that grow: none where no link does.
TEST(HeldLinks, DoWorkOnTheirLengthsAlone) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    Moved moved(seed);
    const Nodes force = moved.forces();
    double fx = 0, fy = 0, torque = 0, power = 0, on_lengths = 0, scale = 0;
    for (std::size_t i = 0; i < moved.u.size(); ++i) {
      fx += force.x[i];
      fy += force.y[i];
      torque += moved.nodes.x[i] * force.y[i] - moved.nodes.y[i] * force.x[i];
      power += force.x[i] * moved.u[i] + force.y[i] * moved.v[i];
      scale += std::hypot(force.x[i], force.y[i]);
      const Link link = link_at(moved.nodes.ring(), i);
      const double growth =
          (moved.u[link.to] - moved.u[i]) * link.ex + (moved.v[link.to] - moved.v[i]) * link.ey;
      const double strain = link.length / moved.held.length[i] - 1;
      on_lengths -= (moved.held.tension[i] + modulus * strain) * growth;
    }
    EXPECT_NEAR(fx, 0, 1e-13 * scale);
    EXPECT_NEAR(fy, 0, 1e-13 * scale);
    EXPECT_NEAR(torque, 0, 1e-11 * scale);
    EXPECT_NEAR(power, on_lengths, 1e-12 * scale);
  }
}

TEST(HeldLinks, TensionRisesWithTheRateOfStrain) {
  Moved moved(3);
  const HeldLinks before = moved.held;
  const std::size_t n = moved.u.size();
  const double gain = 4, step = 1e-6;
  update_tension(moved.nodes.ring(), moved.u, moved.v, gain, moved.held);
  Nodes later = moved.nodes;
  for (std::size_t i = 0; i < n; ++i) {
    later.x[i] += step * moved.u[i];
    later.y[i] += step * moved.v[i];
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double now = link_at(moved.nodes.ring(), i).length;
    const double rate = (link_at(later.ring(), i).length / now - 1) / step;
    EXPECT_NEAR(moved.held.tension[i] - before.tension[i], gain * rate, 1e-4);
  }
  EXPECT_EQ(moved.held.length, before.length);
}

/// Where all links pull nothing is left out.
TEST(HeldLinks, StiffnessIsTheSlopeOfTheForces) {
  Moved moved(5);
  for (double& tension : moved.held.tension) tension = 2 + std::abs(tension);
  const std::size_t n = moved.u.size();
  std::vector<Stiffness> terms;
  append_held_stiffness(moved.nodes.ring(), moved.held, modulus, 0, terms);
  ASSERT_EQ(terms.size(), 2 * n);
  std::vector<double> fx(n, 0.0), fy(n, 0.0);
  for (const Stiffness& term : terms) {
    double along = 0;
    for (std::size_t q = 0; q < 3; ++q) {
      along += term.g[2 * q] * moved.u[term.node[q]] + term.g[2 * q + 1] * moved.v[term.node[q]];
    }
    for (std::size_t q = 0; q < 3; ++q) {
      fx[term.node[q]] -= term.k * along * term.g[2 * q];
      fy[term.node[q]] -= term.k * along * term.g[2 * q + 1];
    }
  }
  const double step = 1e-6;
  const auto at = [&](double way) {
    Moved there = moved;
    for (std::size_t i = 0; i < n; ++i) {
      there.nodes.x[i] += way * moved.u[i];
      there.nodes.y[i] += way * moved.v[i];
    }
    return there.forces();
  };
  const Nodes above = at(step), below = at(-step);
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_NEAR(fx[i], (above.x[i] - below.x[i]) / (2 * step), 1e-5);
    EXPECT_NEAR(fy[i], (above.y[i] - below.y[i]) / (2 * step), 1e-5);
  }
}

}  // namespace
}  // namespace rouleau::cells
