#pragma once

#include <array>

#include "engine/operators/sampler.h"

namespace rouleau::operators {

/// The flow through a plane.
struct CrossSection {
  double flux = 0;      ///< integral of the velocity along the plane's normal
  double pressure = 0;  ///< mean of p
};

/// A plane to measure at: the segment between two points, through fluid alone. Its normal is the way from
/// `from` to `to` turned by -90 degrees, so flow along +x through a plane drawn upwards is positive.
struct SamplingPlane {
  std::array<double, 2> from{}, to{};
  SamplingReach reach;
  int panels = 2;  ///< of Simpson's rule: even
};

/// The plane's length.
double length(const SamplingPlane& plane);

/// Measures by quadratic least-squares fits (Sampler) at points along the plane and Simpson's rule, which is
/// exact for a parabola. Needs sorted particles.
CrossSection measure(const particles::ParticleSet& particles, const SamplingPlane& plane);

/// The flux alone.
double measure_flux(const particles::ParticleSet& particles, const SamplingPlane& plane);

/// The same in the memory of a sampler, for those who measure every step.
double measure_flux(const particles::ParticleSet& particles, const SamplingPlane& plane, Sampler& sampler);

}  // namespace rouleau::operators
