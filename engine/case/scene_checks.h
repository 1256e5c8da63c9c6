#pragma once

#include "engine/case/case.h"
#include "engine/case/faults.h"

namespace rouleau {

/// Lengths are read from decimal text: a scene that fits exactly must not fail by the last bit.
inline constexpr double rounding = 1e-9;
inline constexpr double least_particles_across = 8;  ///< of a vessel or a part of it, in either direction
inline constexpr double most_particles = 4e6;        ///< area / spacing^2
inline constexpr double least_gap = 2;               ///< what thrombi must leave open, in spacings
inline constexpr double least_cell_thickness = 2;    ///< mean thickness 2A/P of a cell, in spacings
inline constexpr double most_series_rows = 1e7;
inline constexpr double most_frames = 1e5;

/// Adds a fault for everything in the scene that contradicts something else in it. Parts in which `faults`
/// already names a fault are left out, since what they should have been is not known.
void check_scene(const Case& scene, Faults& faults);

}  // namespace rouleau
