#pragma once

#include <array>

namespace rouleau::operators {

/// One particle's pairs: offsets, distances and neighbours, each of `count`.
struct FitRow {
  const float* dx;
  const float* dy;
  const float* r;
  const int* j;
  int count;
  float radius;
  int j_end;  ///< pairs with j from here on do not count
};

/// Coefficients of derivatives in the basis {X, Y, X^2, XY, Y^2}, offsets in units of half the radius.
struct FitCoefficients {
  std::array<double, 5> dx{}, dy{}, laplacian{};
};

/// What to do where neighbours do not carry a quadratic: for velocities a fit with Tikhonov damping, light on
/// the linear terms and heavy on the quadratic ones.
FitCoefficients damped_fit(const FitRow& row);

/// And for pressures a linear fit, without a Laplacian.
FitCoefficients linear_fit(const FitRow& row);

/// The pairs' weights in a derivative of order 1 or 2: [count]
void write_weights(const FitRow& row, const std::array<double, 5>& coefficients, int order, float* weights);

}  // namespace rouleau::operators
