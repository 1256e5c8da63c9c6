#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// In spacings: how near another membrane must come.
inline constexpr double membrane_contact_range = 0.75;

/// Short-ranged repulsion of a membrane from walls, from other membranes and from distant parts of itself, by
/// the distance between the surfaces. Nothing is done where none are near.
extern const EffectKind contact;

}  // namespace rouleau::effects
