#pragma once

#include <vector>

#include "engine/observe/observer.h"

namespace rouleau::observe {

/// Of a membrane's links as the cell had them at first, l0 apart: link i joins first node i to the next.
struct LinkMaps {
  std::vector<double> strain;  ///< length over unstretched length, less 1
  /// In own units: eq. 10 with the stiffening of crushed links; what holds an inextensible membrane's links.
  std::vector<double> tension;
};

/// None once the cell has left.
LinkMaps link_maps(const effects::State& state, const effects::CellState& cell);

/// Of the unstretched membrane, whose links are all equally long: the share above a threshold.
double share_above(const std::vector<double>& values, double threshold);

/// Strain and tension of every link in the frames; the share of each membrane above a threshold of strain
/// and above one of tension in the series.
extern const ObserverKind membrane_maps;

}  // namespace rouleau::observe
