#pragma once

namespace rouleau::effects {

// What a run is held to after every step. A step that leaves one is taken again, smaller; where that mends
// nothing the run ends.

/// Of |div u - what is wanted| d0 / the greater of the mean inflow velocity and the fastest particle's.
inline constexpr double divergence_bound = 0.5;
/// Of |A / A0 - 1| of a cell.
inline constexpr double area_bound = 0.005;
/// Of a cell's perimeter over that at the start; with the published constants it doubles.
inline constexpr double least_perimeter = 0.5, most_perimeter = 5;
/// Spacings that a cell is thick, twice its area over its perimeter. Under it a run goes on, with a warning:
/// fluid leaks from 1.6 on, and at 1.5 cells tear.
inline constexpr double thin = 2;

}  // namespace rouleau::effects
