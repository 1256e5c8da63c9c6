#include "engine/particles/bins.h"

#include <algorithm>
#include <numeric>

#include "engine/simd/kernels.h"

namespace rouleau::particles {

namespace {

constexpr float far_away = 1e30F;

}  // namespace

BinAxis::BinAxis(double low, double high, double radius, double period)
    : low_(period > 0 ? 0 : low),
      period_(period),
      bins_(period > 0 ? std::max(1, static_cast<int>(2 * period / radius))
                       : static_cast<int>(2 * (high - low) / radius) + 1),
      width_(period > 0 ? period / bins_ : radius / 2),
      per_width_(1 / width_) {}

BinAxis::Runs BinAxis::around(int bin) const {
  Runs runs;
  if (period_ == 0) {
    runs.run[0] = {std::max(bin - reach, 0), std::min(bin + reach, bins_ - 1), 0};
    runs.count = 1;
    return runs;
  }
  for (int at = bin - reach; at <= bin + reach;) {
    const int turns = at >= 0 ? at / bins_ : -((bins_ - 1 - at) / bins_);
    const int first = at - turns * bins_;
    const int length = std::min(bin + reach - at + 1, bins_ - first);
    runs.run[runs.count++] = {first, first + length - 1, turns * period_};
    at += length;
  }
  return runs;
}

void Bins::file(const std::vector<double>& px, const std::vector<double>& py, int first, int last) {
  const int n = last - first;
  begin_.assign(static_cast<std::size_t>(grid_.bins()) + 1, 0);
  bin_of_.resize(n);
  // The kernel reads whole vectors.
  id_.resize(n + simd::lanes);
  filed_x_.resize(n + simd::lanes);
  filed_y_.resize(n + simd::lanes);
  for (int k = 0; k < n; ++k) {
    bin_of_[k] = grid_.bin(px[first + k], py[first + k]);
    ++begin_[bin_of_[k] + 1];
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  next_.assign(begin_.begin(), begin_.end() - 1);
  for (int k = 0; k < n; ++k) {
    const int at = next_[bin_of_[k]]++;
    id_[at] = first + k;
    filed_x_[at] = grid_.x.wrapped(px[first + k]);
    filed_y_[at] = grid_.y.wrapped(py[first + k]);
  }
}

void Bins::collect(int bin, Surroundings& found) const {
  const BinAxis &along_x = grid_.x, &along_y = grid_.y;
  const int own_column = bin / along_y.bins(), own_row = bin % along_y.bins();
  const BinAxis::Runs columns = along_x.around(own_column), rows = along_y.around(own_row);
  std::array<simd::PlaceRun, (2 * BinAxis::reach + 1) * (2 * BinAxis::reach + 1)> runs;
  int count = 0;
  found.count = 0;
  for (int a = 0; a < columns.count; ++a) {
    for (int column = columns.run[a].first; column <= columns.run[a].last; ++column) {
      for (int b = 0; b < rows.count; ++b) {
        const int from = begin_[column * along_y.bins() + rows.run[b].first];
        const int length = begin_[column * along_y.bins() + rows.run[b].last + 1] - from;
        runs[count++] = {from, length, along_x.centre(own_column) - columns.run[a].shift,
                         along_y.centre(own_row) - rows.run[b].shift};
        found.count += length;
      }
    }
  }
  const auto room = static_cast<std::size_t>(found.count + simd::lanes);
  if (room > found.id.size()) {
    for (auto* values : {&found.x, &found.y}) values->resize(2 * room);
    found.id.resize(2 * room);
  }
  simd::kernels().collect({filed_x_.data(), filed_y_.data(), id_.data()}, runs.data(), count, found.x.data(),
                          found.y.data(), found.id.data());
  for (int k = found.count; k < simd::padded(found.count); ++k) found.x[k] = found.y[k] = far_away;
}

}  // namespace rouleau::particles
