#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Feeds particles through the inlet plane in lanes, each at its own velocity and staggered against its
/// neighbours, so that no column enters at once; a waveform may turn them
/// back. A plug is fed at u0 D / (D - d0): the no-slip corners take
/// the flux of one spacing.
extern const EffectKind inflow;

}  // namespace rouleau::effects
