#include "engine/cells/tank_treading.h"

#include <cmath>
#include <complex>
#include <numbers>

namespace rouleau::cells {

namespace {

constexpr double roundness = 0.01;

}  // namespace

double axis_angle(double degrees) {
  // As for a cell's own angle: rounding must not flip -90 and 90.
  const double angle = degrees - 180 * std::floor((degrees + 90) / 180);
  return angle > -90 + 1e-6 ? angle : angle + 180;
}

TankTreading tank_treading(Ring ring, std::span<const double> u, std::span<const double> v) {
  using Complex = std::complex<double>;
  constexpr double turn = 2 * std::numbers::pi;
  const double n = static_cast<double>(ring.size());
  Complex plus = 0, minus = 0, plus_rate = 0, minus_rate = 0;
  for (std::size_t j = 0; j < ring.size(); ++j) {
    const Complex along = std::polar(1.0, turn * static_cast<double>(j) / n);
    // Seen from node 0, so that a small cell far from the origin loses no digits.
    const Complex z(ring.x[j] - ring.x[0], ring.y[j] - ring.y[0]), rate(u[j], v[j]);
    plus += z * std::conj(along);
    minus += z * along;
    plus_rate += rate * std::conj(along);
    minus_rate += rate * along;
  }
  const double turning = (plus_rate / plus).imag();
  constexpr double degrees = 360 / turn;
  if (std::abs(minus) < roundness * std::abs(plus)) {
    return {axis_angle(std::arg(plus) * degrees), turning / turn};
  }
  return {axis_angle((std::arg(plus) - std::arg(minus)) / 2 * degrees),
          (turning - (minus_rate / minus).imag()) / 2 / turn};
}

}  // namespace rouleau::cells
