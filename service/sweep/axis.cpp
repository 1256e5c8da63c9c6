#include "service/sweep/axis.h"

namespace rouleau::service {

std::vector<double> evenly_spaced(double from, double to, std::size_t count) {
  std::vector<double> values(count, from);
  const auto last = static_cast<double>(count) - 1;
  for (std::size_t k = 1; k + 1 < count; ++k) {
    // In this order 1e-6 to 3e-6 has 2e-6 in its middle, and nothing that only comes close to it.
    values[k] = (from * (last - static_cast<double>(k)) + to * static_cast<double>(k)) / last;
  }
  if (count > 1) values.back() = to;
  return values;
}

std::optional<std::size_t> point_count(const std::vector<Axis>& axes, SweepMode mode, std::size_t most) {
  if (axes.empty()) return std::nullopt;
  std::size_t count = mode == SweepMode::zip ? axes.front().values.size() : 1;
  if (mode == SweepMode::grid) {
    for (const Axis& axis : axes) {
      // Divided, since the product of hostile counts may wrap around.
      if (axis.values.empty() || count > most / axis.values.size()) return std::nullopt;
      count *= axis.values.size();
    }
  }
  return count <= most ? std::optional(count) : std::nullopt;
}

std::vector<std::size_t> choice_at(const std::vector<Axis>& axes, SweepMode mode, std::size_t point) {
  std::vector<std::size_t> choice(axes.size(), point);
  if (mode == SweepMode::zip) return choice;
  for (std::size_t a = axes.size(); a-- > 0;) {
    choice[a] = point % axes[a].values.size();
    point /= axes[a].values.size();
  }
  return choice;
}

}  // namespace rouleau::service
