#pragma once

#include "engine/observe/flow_planes.h"
#include "engine/observe/observer.h"

namespace rouleau::observe {

/// The time series of the cells and the flow.
extern const ObserverKind series;

/// Its columns, in their fixed order.
std::vector<Column> series_columns(const Case& scene);

/// One value a column, SI.
std::vector<double> series_row(const effects::State& state, const FlowPlanes& planes);

}  // namespace rouleau::observe
