#pragma once

#include "engine/case/case_keys.h"

namespace rouleau {

/// The keys that say how a scene is computed and what is kept of it.
Key effects_key();
Key numerics_key();
Key output_key();
Key probes_key();

}  // namespace rouleau
