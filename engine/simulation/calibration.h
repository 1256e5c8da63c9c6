#pragma once

#include "engine/plan/machine.h"

namespace rouleau {

/// Runs a small built-in scene, plasma in a short vessel, for about half a second of processor time, and
/// compares that with what the plan expects of it. Other work of the machine does not count.
Machine measure_machine();

}  // namespace rouleau
