#include "engine/operators/cross_section.h"

#include <algorithm>
#include <cmath>

namespace rouleau::operators {

namespace {

void file_along(const particles::ParticleSet& particles, const SamplingPlane& plane, Sampler& sampler) {
  const auto [x0, x1] = std::minmax(plane.from[0], plane.to[0]);
  const auto [y0, y1] = std::minmax(plane.from[1], plane.to[1]);
  sampler.file(particles, plane.reach, {x0, y0, x1, y1});
}

/// Simpson's rule for the mean along the plane.
template <class Value>
double mean(const SamplingPlane& plane, Value&& value) {
  double sum = 0;
  for (int k = 0; k <= plane.panels; ++k) {
    const double weight = k == 0 || k == plane.panels ? 1 : k % 2 ? 4 : 2;
    const double s = static_cast<double>(k) / plane.panels;
    sum += weight * value(plane.from[0] + s * (plane.to[0] - plane.from[0]),
                          plane.from[1] + s * (plane.to[1] - plane.from[1]));
  }
  return sum / (3.0 * plane.panels);
}

double flux(const Sampler& sampler, const SamplingPlane& plane) {
  const double along_x = plane.to[0] - plane.from[0], along_y = plane.to[1] - plane.from[1];
  return mean(plane, [&](double x, double y) {
    const Velocity velocity = sampler.velocity(x, y);
    return velocity.u * along_y - velocity.v * along_x;
  });
}

}  // namespace

double length(const SamplingPlane& plane) {
  return std::hypot(plane.to[0] - plane.from[0], plane.to[1] - plane.from[1]);
}

double measure_flux(const particles::ParticleSet& particles, const SamplingPlane& plane, Sampler& sampler) {
  file_along(particles, plane, sampler);
  return flux(sampler, plane);
}

double measure_flux(const particles::ParticleSet& particles, const SamplingPlane& plane) {
  Sampler sampler;
  return measure_flux(particles, plane, sampler);
}

CrossSection measure(const particles::ParticleSet& particles, const SamplingPlane& plane) {
  Sampler sampler;
  file_along(particles, plane, sampler);
  return {flux(sampler, plane), mean(plane, [&](double x, double y) { return sampler.pressure(x, y); })};
}

}  // namespace rouleau::operators
