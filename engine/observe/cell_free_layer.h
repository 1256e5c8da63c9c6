#pragma once

#include <array>
#include <vector>

#include "engine/observe/observer.h"

namespace rouleau::observe {

/// What cells leave free beside a wall at one instant, in own units.
struct FreeLayer {
  double mean = 0;   ///< NaN where no cell faces the wall
  double least = 0;  ///< infinite there
};

/// The layer beside the lower and the upper wall of a vessel (of a bifurcation its two outer walls). At
/// stations evenly spaced along the wall, as if no thrombi stood on it, one looks straight across the vessel:
/// the first membrane seen there is the edge of the core of cells, and its shortest distance from this wall,
/// thrombi included, is the layer at that station. So Kim et al. (Am. J. Physiol. Heart Circ. Physiol. 293,
/// H1526 (2007)) and Fedosov et al. (Microcirculation 17, 615 (2010)) take it. The mean is over the stations
/// that face a cell: the stretch of the vessel that cells occupy.
class FreeLayers {
 public:
  explicit FreeLayers(const effects::State& start);

  /// The lower one, the upper one.
  std::array<FreeLayer, 2> measure(const effects::State& state) const;

 private:
  struct Station {
    double x, y;    ///< on the wall without thrombi
    double nx, ny;  ///< into the fluid
    double reach;   ///< to the opposite wall
    double length;  ///< of the wall that it stands for
  };

  struct Wall {
    std::vector<Station> stations;
    std::vector<geometry::Bump> thrombi;
  };

  static Wall wall_of(const geometry::WallChain& chain, const effects::State& start);
  /// Of a point `way` from a station.
  static double distance(const Wall& wall, const Station& from, double way, const effects::State& state);

  std::array<Wall, 2> walls_;
};

/// The layers beside both walls.
extern const ObserverKind cell_free_layer;

}  // namespace rouleau::observe
