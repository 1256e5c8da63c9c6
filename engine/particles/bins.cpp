#include "engine/particles/bins.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rouleau::particles {

BinAxis::BinAxis(double low, double high, double radius, double period)
    : low_(period > 0 ? 0 : low),
      period_(period),
      bins_(period > 0 ? std::max(1, static_cast<int>(2 * period / radius))
                       : static_cast<int>(2 * (high - low) / radius) + 1),
      width_(period > 0 ? period / bins_ : radius / 2) {}

double BinAxis::wrapped(double at) const {
  return period_ > 0 ? at - period_ * std::floor(at / period_) : at;
}

int BinAxis::bin(double at) const {
  const double place = (at - low_) / width_;
  return place > 0 ? static_cast<int>(std::min(place, bins_ - 1.0)) : 0;
}

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
  begin_.assign(static_cast<std::size_t>(x_.bins()) * y_.bins() + 1, 0);
  bin_of_.resize(n);
  id_.resize(n);
  filed_x_.resize(n);
  filed_y_.resize(n);
  for (int k = 0; k < n; ++k) {
    bin_of_[k] = bin(px[first + k], py[first + k]);
    ++begin_[bin_of_[k] + 1];
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  next_.assign(begin_.begin(), begin_.end() - 1);
  for (int k = 0; k < n; ++k) {
    const int at = next_[bin_of_[k]]++;
    id_[at] = first + k;
    filed_x_[at] = x_.wrapped(px[first + k]);
    filed_y_[at] = y_.wrapped(py[first + k]);
  }
}

std::array<float, 2> Bins::relative(double px, double py, int bin) const {
  return {static_cast<float>(x_.wrapped(px) - x_.centre(bin / y_.bins())),
          static_cast<float>(y_.wrapped(py) - y_.centre(bin % y_.bins()))};
}

void Bins::collect(int bin, Surroundings& found) const {
  found.count = 0;
  const BinAxis::Runs columns = x_.around(bin / y_.bins()), rows = y_.around(bin % y_.bins());
  for (int a = 0; a < columns.count; ++a) {
    const double x0 = x_.centre(bin / y_.bins()) - columns.run[a].shift;
    for (int column = columns.run[a].first; column <= columns.run[a].last; ++column) {
      for (int b = 0; b < rows.count; ++b) {
        const double y0 = y_.centre(bin % y_.bins()) - rows.run[b].shift;
        const int from = begin_[column * y_.bins() + rows.run[b].first];
        const int to = begin_[column * y_.bins() + rows.run[b].last + 1];
        const int at = found.count;
        found.count += to - from;
        if (found.count > static_cast<int>(found.id.size())) {
          found.x.resize(found.count);
          found.y.resize(found.count);
          found.id.resize(found.count);
        }
        for (int k = 0; k < to - from; ++k) {
          found.x[at + k] = static_cast<float>(filed_x_[from + k] - x0);
          found.y[at + k] = static_cast<float>(filed_y_[from + k] - y0);
          found.id[at + k] = id_[from + k];
        }
      }
    }
  }
}

}  // namespace rouleau::particles
