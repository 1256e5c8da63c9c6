#pragma once

namespace rouleau {

/// The machine that a plan is made for.
struct Machine {
  /// How much longer a step takes it than the effects state as their cost. 1: it is like the machine on which
  /// those were measured.
  double slowness = 1;
  bool measured = false;  ///< else it is not known, and taken to be 1
};

}  // namespace rouleau
