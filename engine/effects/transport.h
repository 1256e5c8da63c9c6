#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Ends the motion: particles take their new places, and velocity and pressure follow as the fields they
/// are. Pressure is a field of the vessel and no property that a particle carries along; its
/// roughness is smoothed, and its jumps at membranes stay where they are.
extern const EffectKind transport;

}  // namespace rouleau::effects
