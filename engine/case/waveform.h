#pragma once

#include "engine/case/case.h"

namespace rouleau {

/// What the inflow's velocity is multiplied by at `time` (s): linear between the points of the waveform, held
/// before the first and after the last; 1 if it is steady.
double waveform_factor(const Inflow& inflow, double time);

/// The largest magnitude that the factor takes at any time; 1 if the inflow is steady.
double largest_factor(const Inflow& inflow);

}  // namespace rouleau
