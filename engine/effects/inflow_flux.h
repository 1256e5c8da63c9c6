#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Holds the flux at its exact value while particles cross the inlet: each of them changes the sum of the
/// divergences by its own, and the flux of the whole vessel with it (1 % with a plug). A source in the
/// first layers makes up for it before the projection.
extern const EffectKind inflow_flux;

}  // namespace rouleau::effects
