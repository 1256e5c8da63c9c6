#include "engine/simulation/cell_free_flow.h"

#include <cmath>

#include "engine/observe/flow_planes.h"
#include "engine/observe/fluid_segments.h"
#include "engine/observe/unit_flow.h"
#include "engine/simulation/simulation.h"

namespace rouleau {

namespace {

constexpr double settled = 3e-4;
constexpr int most_spans = 20;  // of H^2/nu
constexpr long most_steps = 300;
// A steady flow bears longer steps than a cell does.
constexpr double longer_step = 2;

Case without_cells(const Case& resolved) {
  Case scene = resolved;
  scene.cells.clear();
  scene.effects.clear();
  scene.probes.clear();
  scene.inflow.waveform.clear();
  scene.initial.flow = InitialFlow::developed;
  const double height = scene.vessel.diameter;
  scene.duration = most_spans * height * height / scene.plasma.kinematic_viscosity;
  if (!scene.numerics.time_step) scene.numerics.time_step = longer_step * make_plan(scene).time_step;
  return scene;
}

}  // namespace

std::unique_ptr<const effects::State> cell_free_flow(const Case& resolved) {
  Simulation simulation(without_cells(resolved));
  const effects::State& state = simulation.state();
  const observe::FlowPlanes planes = observe::flow_planes(state);
  const auto resistance = [&] {
    const auto inlet = observe::measure(state.particles, planes.inlet);
    return observe::drive_of(state, inlet) / inlet.flux;
  };
  double before = resistance();
  for (int span = 1; span <= most_spans && !simulation.finished(); ++span) {
    const double end = state.scene.duration * span / most_spans;
    while (simulation.time() < end && !simulation.finished() && state.step < most_steps) simulation.step();
    const double now = resistance();
    if (state.step >= most_steps || std::abs(now / before - 1) < settled) break;
    before = now;
  }
  return std::make_unique<const effects::State>(state);
}

}  // namespace rouleau
