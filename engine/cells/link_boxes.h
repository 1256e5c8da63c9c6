#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "engine/cells/ring.h"

namespace rouleau::cells {

/// A rectangle along the axes that holds some points; empty until one is added.
struct Box {
  double x0 = 1e300, y0 = 1e300, x1 = -1e300, y1 = -1e300;

  void add(double x, double y) {
    x0 = std::min(x0, x);
    y0 = std::min(y0, y);
    x1 = std::max(x1, x);
    y1 = std::max(y1, y);
  }
  Box displaced(double dx, double dy) const { return {x0 + dx, y0 + dy, x1 + dx, y1 + dy}; }
  /// What is in the one is at least this far from what is in the other.
  double distance(const Box& other) const {
    const double dx = std::max({0.0, other.x0 - x1, x0 - other.x1});
    const double dy = std::max({0.0, other.y0 - y1, y0 - other.y1});
    return std::hypot(dx, dy);
  }
};

/// The links of a ring in runs of a few, each within its box, so that links near to one another are found
/// without looking at every pair. Refers to the ring's nodes and is valid until they move.
class LinkBoxes {
 public:
  static constexpr std::size_t run_length = 6;

  explicit LinkBoxes(Ring ring) : ring_(ring) {
    for (std::size_t first = 0; first < ring.size(); first += run_length) {
      Box box;
      for (std::size_t i = first; i < run_end(first); ++i) {
        box.add(ring.x[i], ring.y[i]);
        box.add(ring.x[ring.next(i)], ring.y[ring.next(i)]);
      }
      runs_.push_back(box);
      whole_.add(box.x0, box.y0);
      whole_.add(box.x1, box.y1);
    }
  }

  Ring ring() const { return ring_; }
  const Box& whole() const { return whole_; }
  std::size_t runs() const { return runs_.size(); }
  const Box& box(std::size_t run) const { return runs_[run]; }

  /// Calls visit(i, j) for a link i of `a` and a link j of `b`; every pair nearer than `reach` is among them,
  /// `reach` being read anew for each pair of runs. A ring with itself gives every pair both ways, and each
  /// link with itself.
  template <class Visit>
  static void visit_near(const LinkBoxes& a, const LinkBoxes& b, const double& reach, Visit visit) {
    if (a.whole_.distance(b.whole_) > reach) return;
    for (std::size_t p = 0; p < a.runs(); ++p) {
      if (a.runs_[p].distance(b.whole_) > reach) continue;
      for (std::size_t q = 0; q < b.runs(); ++q) {
        if (a.runs_[p].distance(b.runs_[q]) > reach) continue;
        for (std::size_t i = p * run_length; i < a.run_end(p * run_length); ++i) {
          for (std::size_t j = q * run_length; j < b.run_end(q * run_length); ++j) visit(i, j);
        }
      }
    }
  }

 private:
  std::size_t run_end(std::size_t first) const { return std::min(first + run_length, ring_.size()); }

  Ring ring_;
  Box whole_;
  std::vector<Box> runs_;
};

/// Links between two nodes of a ring, the shorter way round.
inline std::size_t along_ring(std::size_t a, std::size_t b, std::size_t nodes) {
  const std::size_t one_way = a > b ? a - b : b - a;
  return std::min(one_way, nodes - one_way);
}

}  // namespace rouleau::cells
