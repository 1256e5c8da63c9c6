#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace rouleau::particles {

/// The box that particles can be in; whatever strays beyond it is filed at its rim, so that a run that goes
/// wrong cannot make the search grow.
struct Extent {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// A run of bins side by side along one axis, and by how much its particles are displaced to be seen as the
/// nearest images.
struct BinRun {
  int first = 0, last = 0;
  double shift = 0;
};

/// The bins of one direction, each at least half a radius wide, so that whatever is within the radius of a
/// particle is at most two bins away. A period holds a whole number of them.
class BinAxis {
 public:
  static constexpr int reach = 2;

  struct Runs {
    std::array<BinRun, 2 * reach + 1> run;
    int count = 0;
  };

  /// @param period  0: not periodic; else the bins cover [0, period]
  BinAxis(double low, double high, double radius, double period);

  int bins() const { return bins_; }
  double period() const { return period_; }
  double wrapped(double at) const { return period_ > 0 ? at - period_ * std::floor(at / period_) : at; }
  /// The bin of a wrapped coordinate; a stray one, and one that is not a number, goes to the rim.
  int bin(double at) const {
    const double place = (at - low_) * per_width_;
    return place > 0 ? static_cast<int>(std::min(place, bins_ - 1.0)) : 0;
  }
  double centre(int bin) const { return low_ + (bin + 0.5) * width_; }
  /// All bins within reach.
  Runs around(int bin) const;

 private:
  double low_;
  double period_;
  int bins_;
  double width_;
  double per_width_;
};

/// Both directions.
struct BinGrid {
  BinAxis x, y;

  int bins() const { return x.bins() * y.bins(); }
  /// Number of the bin that a position is in.
  int bin(double px, double py) const { return x.bin(x.wrapped(px)) * y.bins() + y.bin(y.wrapped(py)); }
  /// A position relative to the centre of its bin.
  std::array<float, 2> relative(double px, double py, int bin) const {
    return {static_cast<float>(x.wrapped(px) - x.centre(bin / y.bins())),
            static_cast<float>(y.wrapped(py) - y.centre(bin % y.bins()))};
  }
};

/// Positions around one bin relative to its centre, in float: they lose no more than a row of pairs does.
/// Padded for the kernels with places far away.
struct Surroundings {
  std::vector<float> x, y;
  std::vector<int> id;
  int count = 0;
};

/// Some of the particles, filed by bins.
class Bins {
 public:
  explicit Bins(const BinGrid& grid) : grid_(grid) {}

  /// Files the particles from `first` to before `last`.
  void file(const std::vector<double>& px, const std::vector<double>& py, int first, int last);
  /// The bin of the k-th filed particle.
  int bin_of(int k) const { return bin_of_[k]; }
  /// All filed particles that can be within the radius of something in the bin.
  void collect(int bin, Surroundings& found) const;

 private:
  BinGrid grid_;
  std::vector<int> begin_, next_, bin_of_, id_;
  std::vector<double> filed_x_, filed_y_;
};

}  // namespace rouleau::particles
