#include "service/api/downsample.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace rouleau::service {

namespace {

struct Extremes {
  std::size_t least = 0, greatest = 0;  ///< rows
  double span = 0;
};

/// NaN is never an extreme.
Extremes extremes_of(const std::vector<double>& values) {
  Extremes found;
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (!(values[row] >= values[found.least])) found.least = std::isnan(values[row]) ? found.least : row;
    if (!(values[row] <= values[found.greatest]))
      found.greatest = std::isnan(values[row]) ? found.greatest : row;
  }
  found.span = values[found.greatest] - values[found.least];
  return found;
}

/// How far row `row` lies from the line through the ends of its stretch, in spans, summed over the columns.
double salience(const storage::SeriesTable& table, const std::vector<Extremes>& extremes, std::size_t first,
                std::size_t last, std::size_t row) {
  const double along =
      last == first ? 0 : static_cast<double>(row - first) / static_cast<double>(last - first);
  double sum = 0;
  for (std::size_t c = 0; c < table.values.size(); ++c) {
    if (!(extremes[c].span > 0)) continue;
    const auto& values = table.values[c];
    const double line = values[first] + along * (values[last] - values[first]);
    const double distance = std::abs(values[row] - line) / extremes[c].span;
    if (std::isfinite(distance)) sum += distance;
  }
  return sum;
}

}  // namespace

std::vector<std::size_t> downsample(const storage::SeriesTable& table, std::size_t most) {
  const std::size_t rows = table.values.empty() ? 0 : table.values.front().size();
  if (rows <= most) {
    std::vector<std::size_t> all(rows);
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
  }
  std::set<std::size_t> kept{0, rows - 1};
  std::vector<Extremes> extremes;
  for (const auto& values : table.values) {
    extremes.push_back(extremes_of(values));
    kept.insert(extremes.back().least);
    kept.insert(extremes.back().greatest);
  }
  const std::size_t stretches = most > kept.size() ? most - kept.size() : 0;
  for (std::size_t s = 0; s < stretches; ++s) {
    const std::size_t first = rows * s / stretches;
    const std::size_t last = rows * (s + 1) / stretches - 1;
    std::size_t best = first + (last - first) / 2;
    double most_salient = 0;
    for (std::size_t row = first; row <= last; ++row) {
      const double found = salience(table, extremes, first, last, row);
      if (found > most_salient) {
        most_salient = found;
        best = row;
      }
    }
    kept.insert(best);
  }
  return {kept.begin(), kept.end()};
}

}  // namespace rouleau::service
