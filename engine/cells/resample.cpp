#include "engine/cells/resample.h"

#include <cmath>
#include <numeric>

namespace rouleau::cells {

std::vector<double> equal_steps(std::span<const double> lengths, int count) {
  const double total = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  std::vector<double> places;
  std::size_t node = 0;
  double passed = 0;  // up to `node`
  for (int k = 0; k < count; ++k) {
    const double goal = total * k / count;
    while (node + 1 < lengths.size() && passed + lengths[node] <= goal) passed += lengths[node++];
    places.push_back(static_cast<double>(node) + (goal - passed) / lengths[node]);
  }
  return places;
}

std::vector<double> interpolate(std::span<const double> values, std::span<const double> places) {
  const std::size_t n = values.size();
  std::vector<double> result;
  for (const double place : places) {
    const auto node = static_cast<std::size_t>(place);
    const double t = place - static_cast<double>(node);
    const double before = values[(node + n - 1) % n], here = values[node % n], next = values[(node + 1) % n],
                 after = values[(node + 2) % n];
    result.push_back(-t * (t - 1) * (t - 2) / 6 * before + (t + 1) * (t - 1) * (t - 2) / 2 * here -
                     (t + 1) * t * (t - 2) / 2 * next + (t + 1) * t * (t - 1) / 6 * after);
  }
  return result;
}

std::vector<double> between(std::span<const double> lengths, std::span<const double> places) {
  std::vector<double> up_to{0};
  for (const double length : lengths) up_to.push_back(up_to.back() + length);
  const auto measure = [&](double place) {
    const auto node = static_cast<std::size_t>(place);
    return node < lengths.size() ? up_to[node] + (place - static_cast<double>(node)) * lengths[node]
                                 : up_to.back();
  };
  std::vector<double> result;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double next = k + 1 < places.size() ? measure(places[k + 1]) : up_to.back() + measure(places[0]);
    result.push_back(next - measure(places[k]));
  }
  return result;
}

std::vector<double> link_lengths(Ring ring) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    lengths.push_back(std::hypot(ring.x[ring.next(i)] - ring.x[i], ring.y[ring.next(i)] - ring.y[i]));
  }
  return lengths;
}

}  // namespace rouleau::cells
