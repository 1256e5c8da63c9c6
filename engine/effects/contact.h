#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Short-ranged repulsion of a membrane from walls, from other membranes and from distant parts of itself, by
/// the distance between the surfaces. Nothing is done where none are near.
extern const EffectKind contact;

}  // namespace rouleau::effects
