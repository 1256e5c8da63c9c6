#pragma once

#include <vector>

#include "engine/effects/state.h"

namespace rouleau::observe {

/// The planes at which flow through the vessel is measured, six of the spacings at the start inside its
/// openings, each as the segments of it that lie in the fluid. The flux into the vessel counts as positive at
/// the inlet, that out of it at the outlets. In a periodic straight vessel both are the plane at x = 0; a box
/// has no inlet, and one outlet without segments.
struct FlowPlanes {
  std::vector<operators::SamplingPlane> inlet;
  std::vector<std::vector<operators::SamplingPlane>> outlets;
};

FlowPlanes flow_planes(const effects::State& state);

/// How many columns of the series, `outflow` or `outflow0` and so on, a vessel's outlets have.
int outlet_count(const Vessel& vessel);

/// From the inlet's plane to the outlets: the mean pressure at the plane of the inlet, which has been
/// measured, and before that plane as developed flow of that flux has it, less the mean of the pressures
/// given at the outlets. 0 in a vessel without openings.
double pressure_drop(const effects::State& state, const operators::CrossSection& inlet);

}  // namespace rouleau::observe
