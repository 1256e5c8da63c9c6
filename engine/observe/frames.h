#pragma once

#include "engine/observe/observer.h"

namespace rouleau::observe {

/// The moving particles, with the fields that the case asks for.
extern const ObserverKind frames;

/// What it draws of the particles as they are now.
void draw_particles(const effects::State& state, Frame& frame);

}  // namespace rouleau::observe
