#include "engine/effects/length_control.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "engine/cells/link.h"
#include "engine/effects/breach.h"
#include "engine/effects/inextensible.h"
#include "engine/linear/banded_cholesky.h"

namespace rouleau::effects {

namespace {

constexpr double tolerance = 1e-9;  // of a length, relative
constexpr int most_iterations = 8;
constexpr double nearly_round = 1e-3;  // of a . a, what no change of the lengths can make up for

/// What the tension leaves is second order in the step, and what the pressure does to a velocity after it.
/// The least displacement of the nodes that takes it out and leaves the area as it is is J^T m + b a, where J
/// is the gradient of the lengths and a that of the area: J J^T m + b J a = r, what the links lack, and a .
/// J^T m + b a . a = 0, in Newton's way until they lack nothing (the fast projection of Goldenthal et al.,
/// ACM Trans. Graph. 26(3), 49 (2007)).
class LengthControl : public CellEffect {
 public:
  void apply(State& state) override {
    for (std::size_t c = 0; c < state.cells.size(); ++c) {
      const CellState& cell = state.cells[c];
      // Before an outlet a membrane fades: it holds nothing any more.
      if (cell.departure || cell.presence < 1 || cell.held.length.empty()) continue;
      const auto nodes = static_cast<std::size_t>(cell.nodes);
      const std::span<double> x{state.next_x.data() + cell.first_node, nodes},
          y{state.next_y.data() + cell.first_node, nodes};
      if (!restore(cell.held.length, x, y)) {
        throw breach_of_cell(state, static_cast<int>(c), x[0], y[0],
                             {"change of a link's length", off_, tolerance});
      }
    }
  }

 private:
  bool restore(std::span<const double> lengths, std::span<double> x, std::span<double> y) {
    for (int k = 0; k < most_iterations; ++k) {
      measure({x, y}, lengths);
      if (off_ <= tolerance) return true;
      if (!(off_ < 1) || !solve()) return false;
      const auto n = static_cast<int>(x.size());
      for (int i = 0; i < n; ++i) {
        const double m = pulls_[place(i, n)];
        const cells::Link& link = links_[i];
        x[link.from] += along_area_ * area_x_[i] - m * link.ex;
        y[link.from] += along_area_ * area_y_[i] - m * link.ey;
        x[link.to] += m * link.ex;
        y[link.to] += m * link.ey;
      }
    }
    return false;
  }

  void measure(cells::Ring ring, std::span<const double> lengths) {
    const auto n = static_cast<int>(ring.size());
    links_.clear();
    pulls_.resize(ring.size());
    off_ = 0;
    for (int i = 0; i < n; ++i) {
      links_.push_back(cells::link_at(ring, static_cast<std::size_t>(i)));
      pulls_[place(i, n)] = lengths[i] - links_[i].length;
      off_ = std::max(off_, std::abs(links_[i].length / lengths[i] - 1));
    }
  }

  bool solve() {
    const auto n = static_cast<int>(links_.size());
    matrix_.reset(n, 2);
    for (int i = 0; i < n; ++i) {
      const int next = (i + 1) % n;
      const int a = place(i, n), b = place(next, n);
      matrix_.at(a, a) = 2;
      matrix_.at(std::max(a, b), std::min(a, b)) =
          -(links_[i].ex * links_[next].ex + links_[i].ey * links_[next].ey);
    }
    if (!matrix_.factor()) return false;
    matrix_.solve(pulls_);
    keep_area();
    return true;
  }

  /// Not of a circle: whatever keeps its lengths keeps its area.
  void keep_area() {
    const auto n = static_cast<int>(links_.size());
    area_x_.resize(links_.size());
    area_y_.resize(links_.size());
    double size = 0;
    for (int i = 0; i < n; ++i) {
      const cells::Link &before = links_[(i + n - 1) % n], &after = links_[i];
      area_x_[i] = (before.length * before.ey + after.length * after.ey) / 2;
      area_y_[i] = -(before.length * before.ex + after.length * after.ex) / 2;
      size += area_x_[i] * area_x_[i] + area_y_[i] * area_y_[i];
    }
    growth_.resize(links_.size());
    for (int i = 0; i < n; ++i) {
      const int next = (i + 1) % n;
      growth_[place(i, n)] =
          (area_x_[next] - area_x_[i]) * links_[i].ex + (area_y_[next] - area_y_[i]) * links_[i].ey;
    }
    answer_ = growth_;
    matrix_.solve(answer_);
    const double gained = std::inner_product(growth_.begin(), growth_.end(), pulls_.begin(), 0.0);
    const double free = size - std::inner_product(growth_.begin(), growth_.end(), answer_.begin(), 0.0);
    along_area_ = free > nearly_round * size ? -gained / free : 0;
    for (std::size_t i = 0; i < pulls_.size(); ++i) pulls_[i] -= along_area_ * answer_[i];
  }

  /// The ring folded flat: 0, n - 1, 1, n - 2, ..., so that neighbours are at most two rows apart.
  static int place(int link, int links) { return 2 * link < links ? 2 * link : 2 * (links - 1 - link) + 1; }

  linear::BandedCholesky matrix_;
  std::vector<cells::Link> links_;
  std::vector<double> pulls_;            ///< [links] m, in the rows of the matrix, as growth_ and answer_
  std::vector<double> growth_, answer_;  ///< J a, and what solves J J^T for it
  std::vector<double> area_x_, area_y_;  ///< [nodes] a
  double along_area_ = 0;                ///< b
  double off_ = 0;
};

}  // namespace

const EffectKind length_control{
    "length_control",
    Stage::motion,
    true,
    [](const Case& scene) {
      if (!is_inextensible(scene)) return Need{false, "no membrane is inextensible", "/effects/inextensible"};
      return of_accurate_scheme(
          scene, {true, "an inextensible membrane's links keep their lengths", "/effects/inextensible"});
    },
    [](State&) -> std::unique_ptr<Effect> { return std::make_unique<LengthControl>(); },
    CellEffect::rests,
    {},
    {.membrane_node = 50}};

}  // namespace rouleau::effects
