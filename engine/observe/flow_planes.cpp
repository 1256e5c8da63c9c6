#include "engine/observe/flow_planes.h"

#include "engine/observe/fluid_segments.h"

namespace rouleau::observe {

namespace {

// In spacings at the start, as planes stay where they are: clear of the corners where a plug meets the walls.
constexpr double depth = 6;

std::vector<operators::SamplingPlane> inside(const effects::State& state, const geometry::Opening& opening) {
  const double beyond = -depth * state.start_spacing;
  return fluid_segments(state, opening.at(0, beyond), opening.at(opening.width, beyond));
}

}  // namespace

int outlet_count(const Vessel& vessel) {
  return vessel.shape == Shape::bifurcation ? 2 : 1;
}

FlowPlanes flow_planes(const effects::State& state) {
  const geometry::Outline& outline = state.outline;
  FlowPlanes planes;
  if (outline.inlets().empty()) {
    if (state.scene.vessel.shape == Shape::straight) {
      planes.inlet = fluid_segments(state, {0, 0}, {0, outline.height()});
    }
    planes.outlets.push_back(planes.inlet);
    return planes;
  }
  planes.inlet = inside(state, outline.inlets().front());
  for (const geometry::Opening& outlet : outline.outlets()) planes.outlets.push_back(inside(state, outlet));
  return planes;
}

double pressure_drop(const effects::State& state, const operators::CrossSection& inlet) {
  if (state.outline.inlets().empty()) return 0;
  const double height = state.outline.inlets().front().width;
  const double developed_slope = 12 * state.viscosity * inlet.flux / (height * height * height);
  double given = 0;
  const int outlets = outlet_count(state.scene.vessel);
  for (int k = 0; k < outlets; ++k) given += state.scene.outflow.pressure[k] / outlets;
  return inlet.pressure + developed_slope * depth * state.start_spacing - given / state.scales.pressure();
}

}  // namespace rouleau::observe
