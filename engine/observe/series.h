#pragma once

#include <vector>

#include "engine/effects/state.h"
#include "engine/observe/flow_planes.h"
#include "engine/observe/output.h"

namespace rouleau::observe {

/// Columns of the time series of a scene, in their fixed order.
std::vector<Column> series_columns(const Case& scene);

/// One value a column, SI.
std::vector<double> series_row(const effects::State& state, const FlowPlanes& planes);

}  // namespace rouleau::observe
