#pragma once

namespace rouleau::effects {

// What a run is held to after every step. A step that leaves one is taken again, smaller; where that mends
// nothing the run ends. What grows over many steps ends it at once: smaller ones would only crowd at the
// bound.

/// Of |div u - what is wanted| d0 / the greater of the mean inflow velocity and the fastest particle's.
inline constexpr double divergence_bound = 0.5;
/// Of the change of a cell's area in one step, over its area at the start.
inline constexpr double area_step_bound = 0.002;
/// Of |A / A0 - 1| of a cell: beyond the first there is a warning, at the second the run ends.
inline constexpr double area_warning = 0.005, area_bound = 0.02;
/// Of a cell's perimeter over that at the start, where the run ends; with the published constants it doubles,
/// with a hundredth of them it grows more than fivefold behind a thrombus.
inline constexpr double least_perimeter = 0.5, most_perimeter = 10;
/// Spacings that a cell is thick, twice its area over its perimeter. Under it a run goes on, with a warning:
/// fluid leaks from 1.6 on, and at 1.5 cells tear.
inline constexpr double thin = 2;

}  // namespace rouleau::effects
