#pragma once

#include <span>
#include <vector>

#include "engine/effects/state.h"
#include "engine/operators/cross_section.h"

namespace rouleau::observe {

using Point = std::array<double, 2>;

/// Whether a point is in the fluid between the open ends; on a wall and at an end it is.
bool in_fluid(const effects::State& state, const Point& point);

/// The parts of the line between two points that lie in the fluid, as planes to measure at: Simpson's rule
/// takes two panels a spacing. A gap or a part narrower than a quarter of a spacing may be missed.
std::vector<operators::SamplingPlane> fluid_segments(const effects::State& state, const Point& from,
                                                     const Point& to);

/// The flux through all of them and the mean pressure over them.
operators::CrossSection measure(const particles::ParticleSet& particles,
                                std::span<const operators::SamplingPlane> segments);

/// The flux alone.
double total_flux(const particles::ParticleSet& particles,
                  std::span<const operators::SamplingPlane> segments);

/// How far the fits of this scene reach.
operators::SamplingReach sampling_reach(const effects::State& state);

}  // namespace rouleau::observe
