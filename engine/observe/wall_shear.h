#pragma once

#include <vector>

#include "engine/observe/observer.h"

namespace rouleau::observe {

/// Shear stress of the plasma on the walls, tau = mu du_t/dn at nodes about a spacing apart: u_t is the
/// velocity along the wall in the direction of +x (of +y where a wall stands upright), which is from the
/// inlet to the outlets, less the wall's own, and n points into the fluid.
///
/// u_t is fitted by least squares, weight (1 - r/radius)^2, to the particles to which this piece of wall is
/// the nearest, as n (a + b s + c n + d s^2) in the distance n from it and the way s along it, so that the
/// fluid sticks to the wall on an arc as well; a is the slope wanted. Exact for a parabola along a straight
/// wall. Without d the crest of a bump of four spacings, where the stress peaks, would lose 5 % more.
class WallShear : public Observer {
 public:
  explicit WallShear(const effects::State& state);

  /// In SI units, as the header has them.
  WallNodes nodes() const;

  /// [nodes] Pa; NaN where no particle is near.
  std::vector<float> stress(const effects::State& state) const;

  void describe(Recorded& recorded) const override { recorded.walls = nodes(); }
  void draw(const effects::State& state, Frame& frame) override { frame.wall_shear_stress = stress(state); }

 private:
  struct Node {
    double x = 0, y = 0;
    double tx = 1, ty = 0;  ///< along the wall, the fluid on its left
    double radius = 0;      ///< of an arc that bulges into the fluid, 0: straight
    double speed = 0;       ///< of the wall along (tx, ty)
    double sign = 1;        ///< whether (tx, ty) is the direction in which stress is positive
    double arc_length = 0;
    int wall = 0;
  };

  void add_wall(const geometry::WallChain& chain, double spacing, int number);
  double slope(const effects::State& state, const Node& node,
               const std::vector<operators::SampledParticle>& near, double reach) const;

  std::vector<Node> nodes_;
  double length_unit_;
};

extern const ObserverKind wall_shear_stress;

}  // namespace rouleau::observe
