#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Puts the nodes of inextensible membranes where every link has the length that it keeps.
extern const EffectKind length_control;

}  // namespace rouleau::effects
