#pragma once

#include <array>

#include "engine/effects/state.h"

namespace rouleau {

/// The flow that the plasma starts with.
class InitialVelocity {
 public:
  explicit InitialVelocity(const effects::State& state);

  std::array<double, 2> at(double x, double y) const;
  /// Over the density: of plasma at rest in a closed vessel what carries its weight; 0 where the flow is not
  /// known exactly.
  double pressure(double x, double y) const;

 private:
  std::array<double, 2> developed(double x, double y) const;

  const geometry::Outline& outline_;
  InitialFlow flow_;
  double mean_ = 1;                      ///< of the developed flow in the trunk
  std::array<double, 2> weight_{};       ///< acceleration that walls on all sides carry
  std::array<double, 2> branch_mean_{};  ///< and in each branch
};

}  // namespace rouleau
