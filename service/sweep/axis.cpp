#include "service/sweep/axis.h"

#include <cmath>

namespace rouleau::service {

std::vector<double> evenly_spaced(double from, double to, std::size_t count) {
  std::vector<double> values(count, from);
  for (std::size_t k = 1; k < count; ++k) {
    values[k] = std::lerp(from, to, static_cast<double>(k) / static_cast<double>(count - 1));
  }
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
