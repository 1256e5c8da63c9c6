#pragma once

#include "engine/observe/flow_planes.h"
#include "engine/observe/observer.h"

namespace rouleau::observe {

/// The share of cells in a straight vessel, by area.
struct Hematocrit {
  double tube = 0;       ///< H_T: of what the vessel holds
  double discharge = 0;  ///< H_D: of what flows through it; NaN where nothing flows
  /// H_T / H_D (Fahraeus, Physiol. Rev. 9, 241 (1929)): the mean velocity of the flow over that of the cells.
  double ratio() const { return tube / discharge; }
};

/// Mean flux of all that flows, and of the cells: averaged along the vessel, sum of area times velocity over
/// its length.
struct CellFlux {
  double all = 0;
  double cells = 0;
  double tube_hematocrit = 0;
};

CellFlux cell_flux(const effects::State& state, const FlowPlanes& planes);

Hematocrit hematocrit(const CellFlux& flux);

/// H_T / H_D in round glass tubes by the fit of Pries, Neuhaus and Gaehtgens (Am. J. Physiol. Heart Circ.
/// Physiol. 263, H1770 (1992)).
/// @param diameter  m
double fahraeus_ratio_of_tubes(double diameter, double discharge_hematocrit);

/// Both hematocrits and their ratio, at each time and over the run.
extern const ObserverKind fahraeus;

}  // namespace rouleau::observe
