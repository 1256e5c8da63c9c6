#pragma once

#include "engine/effects/effect.h"

namespace rouleau::effects {

/// Pressure projection, incremental and in rotational form: L phi = (div u* - s) / dt,
/// u = u* - dt grad phi, p += phi - nu (div u* - s). Replaces the density source of eq. 7.
extern const EffectKind pressure_rotational;

}  // namespace rouleau::effects
