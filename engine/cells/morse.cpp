#include "engine/cells/morse.h"

#include <cmath>

#include "engine/cells/link.h"

namespace rouleau::cells {

namespace {

// Over beta, from r0 on: where the fading begins, and over what length.
constexpr double fading_begins = 3, fading_length = 2;

/// A value and its first two derivatives by the gap.
struct Curve {
  double value, first, second;
};

Curve potential(const MorseLaw& law, double gap) {
  const double e = std::exp(law.scaling * (law.distance - gap));
  return {law.depth * (e * e - 2 * e), 2 * law.scaling * law.depth * (e - e * e),
          2 * law.scaling * law.scaling * law.depth * (2 * e * e - e)};
}

/// From 1 to 0 with two continuous derivatives.
Curve fading(const MorseLaw& law, double gap) {
  const double t = ((gap - law.distance) * law.scaling - fading_begins) / fading_length;
  if (t <= 0) return {1, 0, 0};
  if (t >= 1) return {0, 0, 0};
  const double by_gap = law.scaling / fading_length;
  return {1 - t * t * t * (10 - 15 * t + 6 * t * t), -30 * by_gap * t * t * (1 - t) * (1 - t),
          -60 * by_gap * by_gap * t * (1 - t) * (1 - 2 * t)};
}

/// Half of both links of a node.
double length_of_node(Ring ring, std::size_t node) {
  return (link_at(ring, ring.previous(node)).length + link_at(ring, node).length) / 2;
}

}  // namespace

double MorseLaw::energy(double gap) const {
  return potential(*this, gap).value * fading(*this, gap).value;
}

double MorseLaw::force(double gap) const {
  const Curve p = potential(*this, gap), f = fading(*this, gap);
  return -(p.first * f.value + p.value * f.first);
}

double MorseLaw::slope(double gap) const {
  const Curve p = potential(*this, gap), f = fading(*this, gap);
  return p.second * f.value + 2 * p.first * f.first + p.value * f.second;
}

void append_adhesion(const LinkBoxes& a, int first_a, const LinkBoxes& b, int first_b, double reach,
                     std::vector<Contact>& contacts) {
  const std::size_t before = contacts.size();
  append_contacts(a, first_a, b, first_b, reach, -1, contacts);
  for (Contact& contact : std::span(contacts).subspan(before)) {
    contact.weight *= length_of_node(a.ring(), static_cast<std::size_t>(contact.point - first_a)) / 2;
  }
}

void add_adhesion_forces(std::span<const Contact> contacts, Ring a, int first_a, const MorseLaw& law,
                         std::span<double> fx, std::span<double> fy) {
  add_contact_forces(contacts, law, fx, fy);
  for (const Contact& contact : contacts) {
    const auto node = static_cast<std::size_t>(contact.point - first_a);
    const Link before = link_at(a, a.previous(node)), after = link_at(a, node);
    const double tension = contact.weight * law.energy(contact.gap) / (before.length + after.length);
    for (const Link& link : {before, after}) {
      const auto from = static_cast<std::size_t>(first_a) + link.from,
                 to = static_cast<std::size_t>(first_a) + link.to;
      fx[from] += tension * link.ex;
      fy[from] += tension * link.ey;
      fx[to] -= tension * link.ex;
      fy[to] -= tension * link.ey;
    }
  }
}

}  // namespace rouleau::cells
