#pragma once

#include "engine/particles/particle_set.h"

namespace rouleau::operators {

/// The flow through a plane across a straight vessel 0 < y < height.
struct CrossSection {
  double flux = 0;      ///< integral of u over y
  double pressure = 0;  ///< mean of p over y
};

/// A plane to measure at, and the reach and number of the fits it is measured by.
struct SamplingPlane {
  double x = 0;
  double height = 1;
  double radius = 0;  ///< of the fits
  int panels = 2;     ///< of Simpson's rule: even
};

/// Measures by quadratic least-squares fits at points across the vessel (walls are velocity data) and
/// Simpson's rule, which is exact for a parabola. Needs sorted particles.
CrossSection measure(const particles::ParticleSet& particles, const SamplingPlane& plane);

/// The flux alone.
double measure_flux(const particles::ParticleSet& particles, const SamplingPlane& plane);

}  // namespace rouleau::operators
