#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// The inflow's velocity over time: sets the factor by which the inlet's lanes move and their flux is kept.
extern const EffectKind waveform;

}  // namespace rouleau::effects
