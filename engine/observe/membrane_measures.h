#pragma once

#include "engine/cells/shape_class.h"
#include "engine/effects/state.h"

namespace rouleau::observe {

/// What else is observed of a cell at one instant, in SI units.
struct MembraneMeasures {
  double mean_strain = 0;              ///< of its links: length over unstretched length, less 1
  double greatest_strain = 0;          ///< of the link that is stretched most
  double tank_treading_phase = 0;      ///< degrees in (-90, 90], against the start (cells::TankTreading)
  double tank_treading_frequency = 0;  ///< 1/s, counter-clockwise positive
  cells::ShapeClass shape = cells::ShapeClass::other;
  double thickness = 0;  ///< mean: twice the area over the perimeter
  double wall_gap = 0;   ///< least distance from the walls; infinite where there are none
  double cell_gap = 0;   ///< least distance from another cell or its image; infinite where there is none
};

/// Of cell k.
MembraneMeasures measure_membrane(const effects::State& state, std::size_t k);

}  // namespace rouleau::observe
