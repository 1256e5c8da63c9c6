#include "engine/cells/contact.h"

#include <algorithm>
#include <cmath>

namespace rouleau::cells {

namespace {

constexpr double least_gap = 0.05;  // of the range

struct Projection {
  double s = 0;  ///< where along the link's line, held between 0 and 1
  int end = 0;   ///< -1: the first end is nearest, 1: the last one
};

Projection project(Ring ring, std::size_t link, double px, double py) {
  const std::size_t to = ring.next(link);
  const double ex = ring.x[to] - ring.x[link], ey = ring.y[to] - ring.y[link];
  const double length2 = ex * ex + ey * ey;
  if (length2 == 0) return {0, -1};
  const double s = ((px - ring.x[link]) * ex + (py - ring.y[link]) * ey) / length2;
  if (s <= 0) return {0, -1};
  if (s >= 1) return {1, 1};
  return {s, 0};
}

/// What a point has to do with link j of a ring and with the node that it begins at: the terms of its energy
/// that are nearer than `range`. `far(link)` says whether a link counts.
template <class Far>
void append_terms(Ring ring, int first, std::size_t j, double px, double py, double radius, double range,
                  int point, Far far, std::vector<Contact>& contacts) {
  const auto append = [&](double s, double weight) {
    const std::size_t to = ring.next(j);
    const double ex = ring.x[to] - ring.x[j], ey = ring.y[to] - ring.y[j];
    const double dx = px - ring.x[j] - s * ex, dy = py - ring.y[j] - s * ey;
    const double distance = std::hypot(dx, dy);
    if (distance - radius >= range) return;
    Contact contact{point, {first + static_cast<int>(j), first + static_cast<int>(to)}, s};
    if (s == 0) contact.link[1] = contact.link[0];
    // A point on the link is pushed to the outside.
    const double length = std::hypot(ex, ey);
    contact.nx = distance > 0 ? dx / distance : (length > 0 ? ey / length : 1);
    contact.ny = distance > 0 ? dy / distance : (length > 0 ? -ex / length : 0);
    contact.gap = distance - radius;
    contact.weight = weight;
    contacts.push_back(contact);
  };
  const std::size_t before = ring.previous(j);
  const bool counts = far(j), counts_before = far(before);
  const Projection here = project(ring, j, px, py);
  if (counts && here.end == 0) append(here.s, 1);
  double at_node = counts && counts_before ? -1 : 0;
  if (counts && here.end < 0) at_node += 1;
  if (counts_before && project(ring, before, px, py).end > 0) at_node += 1;
  if (at_node != 0) append(0, at_node);
}

}  // namespace

double ContactLaw::energy(double gap) const {
  const double q = gap / range;
  if (q >= 1) return 0;
  const double held = std::max(q, least_gap);
  const double barrier = -std::log(held) - 2 * (1 - held) + (1 - held * held) / 2;
  return strength * range * barrier + force(gap) * range * (held - q);
}

double ContactLaw::force(double gap) const {
  const double q = std::max(gap / range, least_gap);
  return q >= 1 ? 0 : strength * (1 - q) * (1 - q) / q;
}

double ContactLaw::slope(double gap) const {
  const double q = std::max(gap / range, least_gap);
  return q >= 1 ? 0 : strength / range * (1 / (q * q) - 1);
}

void append_contacts(const LinkBoxes& a, int first_a, const LinkBoxes& b, int first_b, double range, int skip,
                     std::vector<Contact>& contacts) {
  const Ring from = a.ring(), to = b.ring();
  LinkBoxes::visit_near(a, b, range, [&](std::size_t i, std::size_t j) {
    const auto far = [&](std::size_t link) {
      if (skip < 0) return true;
      const auto least = static_cast<std::size_t>(skip);
      return along_ring(i, link, to.size()) > least && along_ring(i, to.next(link), to.size()) > least;
    };
    append_terms(to, first_b, j, from.x[i], from.y[i], 0, range, first_a + static_cast<int>(i), far,
                 contacts);
  });
}

void append_disc_contacts(const LinkBoxes& boxes, int first, std::array<double, 2> centre, double radius,
                          double range, std::vector<Contact>& contacts) {
  const Ring ring = boxes.ring();
  Box disc;
  disc.add(centre[0], centre[1]);
  if (boxes.whole().distance(disc) > radius + range) return;
  for (std::size_t j = 0; j < ring.size(); ++j) {
    append_terms(
        ring, first, j, centre[0], centre[1], radius, range, -1, [](std::size_t) { return true; }, contacts);
  }
}

}  // namespace rouleau::cells
