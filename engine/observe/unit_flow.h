#pragma once

#include <array>
#include <memory>

#include "engine/observe/observer.h"

namespace rouleau::observe {

/// The steady flow through a vessel without cells, per unit of its flux; in own units, pressure and stress
/// over the density.
class UnitFlow {
 public:
  virtual ~UnitFlow() = default;
  /// What drives it from end to end: the drop of pressure, or in a periodic vessel the body's acceleration
  /// over the length.
  virtual double drive() const = 0;
  virtual std::array<double, 2> velocity(double x, double y) const = 0;
  /// xx, xy and yy of the stress.
  virtual std::array<double, 3> stress(double x, double y) const = 0;
};

/// Between straight parallel walls, periodic or fed with a parabola, Poiseuille flow exactly; else the
/// settled flow of the particles.
std::unique_ptr<const UnitFlow> unit_flow(const effects::State& start, const CellFreeFlow& cell_free);

/// What drives the present flow from end to end, in the same sense.
/// @param inlet  the flow through the plane of the inlet
double drive_of(const effects::State& state, const operators::CrossSection& inlet);

}  // namespace rouleau::observe
