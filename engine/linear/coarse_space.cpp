#include "engine/linear/coarse_space.h"

#include <algorithm>

namespace rouleau::linear {

namespace {

/// Makes the coarse matrix definite where the fine one ignores constants.
constexpr double regularisation = 1e-8;

}  // namespace

void CoarseSpace::reset(const Aggregates& aggregates) {
  aggregates_ = &aggregates;
  matrix_.reset(aggregates.count, aggregates.bandwidth);
  entries_.assign(static_cast<std::size_t>(aggregates.count) * (2 * aggregates.bandwidth + 1), 0);
}

void CoarseSpace::factor(bool constants_ignored) {
  for (int a = 0; a < matrix_.rows(); ++a) {
    for (int b = std::max(0, a - matrix_.bandwidth()); b <= a; ++b) {
      matrix_.at(a, b) = 0.5 * (entries_[place(a, b)] + entries_[place(b, a)]);
    }
    double& diagonal = matrix_.at(a, a);
    // An aggregate without particles stands alone with a harmless diagonal.
    if (!(diagonal > 0)) diagonal = 1;
    if (constants_ignored) diagonal *= 1 + regularisation;
  }
  usable_ = matrix_.factor();
}

}  // namespace rouleau::linear
