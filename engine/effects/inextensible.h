#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Membranes whose links keep their lengths: tension is the Lagrange multiplier of that, instead of what a
/// spring makes of a strain. Stands in for `stretch`.
/// Whether the case asks for them.
bool is_inextensible(const Case& scene);

extern const EffectKind inextensible;

}  // namespace rouleau::effects
