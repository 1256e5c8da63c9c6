#pragma once

#include <vector>

#include "engine/effects/state.h"
#include "engine/observe/output.h"

namespace rouleau::observe {

/// Columns of the time series of a scene, in their fixed order.
std::vector<Column> series_columns(const Case& scene);

/// The planes at which flow through the ends is measured: six spacings inside the vessel.
double inflow_plane(const effects::State& state);
double outflow_plane(const effects::State& state);

/// One value a column, SI.
std::vector<double> series_row(const effects::State& state);

}  // namespace rouleau::observe
