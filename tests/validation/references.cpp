#include "tests/validation/references.h"

#include <cmath>
#include <complex>
#include <fstream>
#include <numbers>
#include <string>

#include <nlohmann/json.hpp>

namespace rouleau::validation {

namespace {

using std::numbers::pi;

constexpr int terms = 200;  // from time 1e-3 on the last is nothing

}  // namespace

const nlohmann::json& reference(std::string_view name) {
  static const nlohmann::json all = [] {
    std::ifstream file(ROULEAU_REFERENCES);
    return nlohmann::json::parse(file);
  }();
  return all.at(std::string(name));
}

double couette_start(double y, double time) {
  double u = y;
  for (int n = 1; n < terms; ++n) {
    const double sign = n % 2 == 0 ? 1 : -1;
    u += 2 * sign / (n * pi) * std::sin(n * pi * y) * std::exp(-n * n * pi * pi * time);
  }
  return u;
}

double poiseuille_start(double y, double time) {
  double missing = 0;
  for (int n = 1; n < terms; n += 2) {
    missing += std::sin(n * pi * y) * std::exp(-n * n * pi * pi * time) / std::pow(n, 3);
  }
  return 4 * y * (1 - y) - 32 / std::pow(pi, 3) * missing;
}

double poiseuille(double y) {
  return 6 * y * (1 - y);
}

double womersley(double y, double phase, double number) {
  using Complex = std::complex<double>;
  const Complex lambda = number * std::polar(1.0, pi / 4);
  const Complex profile = 1.0 - std::cosh(lambda * (2 * y - 1)) / std::cosh(lambda);
  const Complex mean = 1.0 - std::tanh(lambda) / lambda;
  return (std::polar(1.0, phase) * profile / mean).imag();
}

std::array<double, 2> taylor_green(double x, double y) {
  const double k = 2 * pi;
  return {-std::cos(k * x) * std::sin(k * y), std::sin(k * x) * std::cos(k * y)};
}

double taylor_green_decay_rate(double viscosity) {
  return 2 * std::pow(2 * pi, 2) * viscosity;
}

double network_share(double length, double diameter, double other_length, double other_diameter) {
  const double conductance = std::pow(diameter, 3) / length;
  return conductance / (conductance + std::pow(other_diameter, 3) / other_length);
}

}  // namespace rouleau::validation
