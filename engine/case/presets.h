#pragma once

#include "engine/case/case.h"

namespace rouleau {

/// Every knob as `preset` sets it.
Numerics preset_numerics(Preset preset);

}  // namespace rouleau
