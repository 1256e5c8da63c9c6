#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "engine/geometry/outline.h"

namespace rouleau::geometry {

namespace {

// In spacings. Behind a wall's bend the layers are denser than the spacing, though not so dense that
// particles in front of it would feel it.
constexpr double least_gap = 0.5;
constexpr double rounding = 1e-6;

/// Points no nearer to one another than `gap`, found by squares of that size.
class SparsePoints {
 public:
  explicit SparsePoints(double gap) : gap_(gap) {}

  /// Adds a point unless it is too near to another.
  void add(const Point& p) {
    const std::int64_t column = square(p[0]), row = square(p[1]);
    for (std::int64_t c = column - 1; c <= column + 1; ++c) {
      for (std::int64_t r = row - 1; r <= row + 1; ++r) {
        const auto [begin, end] = by_square_.equal_range(key(c, r));
        for (auto at = begin; at != end; ++at) {
          const Point& other = points_[at->second];
          if (std::hypot(p[0] - other[0], p[1] - other[1]) < gap_ * (1 - rounding)) return;
        }
      }
    }
    by_square_.emplace(key(column, row), points_.size());
    points_.push_back(p);
  }

  std::vector<Point> take() { return std::move(points_); }

 private:
  std::int64_t square(double x) const { return static_cast<std::int64_t>(std::floor(x / gap_)); }
  // Distinct squares may share a key: the distance decides.
  static std::int64_t key(std::int64_t column, std::int64_t row) { return column * 1'000'003 + row; }

  double gap_;
  std::vector<Point> points_;
  std::unordered_multimap<std::int64_t, std::size_t> by_square_;
};

}  // namespace

std::vector<Point> Outline::ghosts(const std::vector<WallNode>& nodes, int layers, double spacing) const {
  SparsePoints points(least_gap * spacing);
  for (int layer = 1; layer <= layers; ++layer) {
    const double depth = layer * spacing;
    for (const WallNode& node : nodes) {
      const Point p{node.x - depth * node.nx, node.y - depth * node.ny};
      if (distance(p[0], p[1]).value <= -(least_gap - rounding) * spacing) points.add(p);
    }
  }
  return points.take();
}

}  // namespace rouleau::geometry
