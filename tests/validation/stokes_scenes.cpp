#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "engine/observe/flow_planes.h"
#include "engine/observe/fluid_segments.h"
#include "engine/observe/wall_shear.h"
#include "tests/validation/flow.h"
#include "tests/validation/references.h"

namespace rouleau::validation {

namespace {

constexpr double height = 10e-6;
constexpr double velocity = 0.005;

/// In mu U/H, at the node of the lower wall nearest to `x` in heights.
double wall_shear_near(const effects::State& state, double x) {
  const observe::WallShear shear(state);
  const WallNodes nodes = shear.nodes();
  const std::vector<float> stress = shear.stress(state);
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < nodes.x.size(); ++i) {
    const auto away = [&](std::size_t k) { return std::abs(nodes.x[k] / state.scales.length - x); };
    if (nodes.wall[i] == 0 && away(i) < away(nearest)) nearest = i;
  }
  return stress.at(nearest) / (state.scales.pressure() * state.viscosity);
}

/// What part of the flow takes the lower branch.
double lower_share(const effects::State& state) {
  const observe::FlowPlanes planes = observe::flow_planes(state);
  const double lower = observe::total_flux(state.particles, planes.outlets.at(0));
  const double upper = observe::total_flux(state.particles, planes.outlets.at(1));
  return lower / (lower + upper);
}

Measurement run_split(const Resolution& resolution, const std::array<Branch, 2>& branches, double exact) {
  constexpr double trunk = 20e-6;
  Case scene;
  scene.vessel = {2 * trunk, trunk};
  scene.vessel.shape = Shape::bifurcation;
  scene.vessel.branches = branches;
  scene.inflow = {velocity, Profile::parabolic, {}};
  scene.numerics = numerics_at(resolution, trunk);
  scene.duration = 4e-4;  // H^2/nu of the trunk
  Flow flow(scene);
  flow.finish();
  Measurement m = flow.measurement();
  m.errors = {{"share", std::abs(lower_share(flow.state()) / exact - 1)}};
  return m;
}

}  // namespace

Measurement run_bump(const Resolution& resolution, const std::string& name, bool on_both_walls) {
  const nlohmann::json& exact = reference("bumps").at(name);
  const double radius = exact.at("radius");
  constexpr double length = 6, middle = 3;  // heights
  Case scene;
  scene.vessel = {length * height, height};
  scene.inflow = {velocity, Profile::parabolic, {}};
  scene.thrombi.push_back({Wall::lower, middle * height, radius * height});
  if (on_both_walls) scene.thrombi.push_back({Wall::upper, middle * height, radius * height});
  scene.numerics = numerics_at(resolution, height);
  scene.output.fields = {Field::wall_shear_stress};
  scene.duration = 1e-3;  // ten times H^2/nu: the pressure starts from that of no flow and is slow to follow
  Flow flow(scene);
  flow.finish();

  const effects::State& state = flow.state();
  const auto sampler = flow.sampler();
  const double top = on_both_walls ? 1 - radius : 1;
  double peak = 0;
  for (int k = 1; k < 400; ++k) {
    peak = std::max(peak, sampler.velocity(middle, radius + (top - radius) * k / 400).u);
  }
  const auto inlet = observe::measure(state.particles, observe::flow_planes(state).inlet);
  const double drop = observe::pressure_drop(state, inlet) / state.viscosity - 12 * length;
  const auto off = [&](double value, const char* of) {
    return std::abs(value / exact.at(of).get<double>() - 1);
  };
  Measurement m = flow.measurement();
  m.errors = {{"peak_velocity", off(peak, "peak_velocity")},
              {"extra_pressure_drop", off(drop, "extra_pressure_drop")},
              {"crest_shear", off(wall_shear_near(state, middle), "crest_shear")}};
  if (exact.contains("throat_profile")) {
    double most = 0;
    for (const auto& [y, u] : exact.at("throat_profile").get<Table>()) {
      most = std::max(most, std::abs(sampler.velocity(middle, y).u / u - 1));
    }
    m.errors.emplace_back("throat_profile", most);
  }
  return m;
}

Measurement run_bifurcation(const Resolution& resolution) {
  return run_split(resolution, {Branch{40e-6, 10e-6}, Branch{40e-6, 10e-6}}, 0.5);
}

// Branches ten diameters long, beside which the junction takes little.
Measurement run_unequal_bifurcation(const Resolution& resolution) {
  constexpr Branch lower{120e-6, 12e-6}, upper{80e-6, 8e-6};
  return run_split(resolution, {lower, upper},
                   network_share(lower.length, lower.diameter, upper.length, upper.diameter));
}

}  // namespace rouleau::validation
