#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Membranes whose links keep their lengths: tension is the Lagrange multiplier of that, instead of what a
/// spring makes of a strain. Stands in for `stretch`.
extern const EffectKind inextensible;

/// Whether the case asks for them.
inline bool is_inextensible(const Case& scene) {
  const auto wish = scene.effects.find("inextensible");
  return wish != scene.effects.end() && wish->second.position == Switch::on;
}

}  // namespace rouleau::effects
