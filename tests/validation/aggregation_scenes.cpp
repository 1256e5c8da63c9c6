#include <algorithm>
#include <cmath>
#include <string>

#include <nlohmann/json.hpp>

#include "engine/cells/gap.h"
#include "engine/cells/morse.h"
#include "tests/validation/flow.h"
#include "tests/validation/references.h"

namespace rouleau::validation {

namespace {

constexpr double radius = 3.18e-6;  // of the circle with a vesicle's perimeter
constexpr double bend_modulus = 4.8e-18;

EffectWish potential(double depth, double distance, double scaling) {
  return {Switch::on,
          {{"well_depth", depth}, {"zero_force_distance", distance}, {"scaling_factor", scaling}}};
}

RedCell upright(double x, double y, double fill) {
  RedCell cell;
  cell.x = x;
  cell.y = y;
  cell.diameter = 2 * radius;
  cell.fill = fill;
  cell.bend_modulus = bend_modulus;
  cell.stretch_modulus = 1e-3;  // of the shape at the start, which is then held
  return cell;
}

/// How long a pair's contact is for the same energy at the least of the potential, and one cell's size; in R.
struct Adhered {
  double contact = 0, across = 0, along = 0;
};

Adhered measured(const effects::State& state, const cells::MorseLaw& law) {
  const cells::LinkBoxes left(state.ring(state.cells[0])), right(state.ring(state.cells[1]));
  std::vector<cells::Contact> contacts;
  cells::append_adhesion(left, 0, right, 0, law.reach(), contacts);
  cells::append_adhesion(right, 0, left, 0, law.reach(), contacts);
  const double unit = state.scales.length / radius;
  const cells::Box& box = left.whole();
  return {-cells::contact_energy(contacts, law) / law.depth * unit, (box.x1 - box.x0) * unit,
          (box.y1 - box.y0) * unit};
}

/// Two vesicles side by side at rest, until they have found their shape.
Adhered adhered(double alpha, double adhesion, const Resolution& resolution, Measurement& sum) {
  const double distance = 0.13 * radius, scaling = 100 / radius;
  const double depth = adhesion * bend_modulus / (radius * radius);
  Case scene;
  scene.vessel = {6 * radius, 4 * radius};
  scene.vessel.ends = Ends::periodic;
  for (const double side : {-1.0, 1.0}) {
    scene.cells.push_back(upright((3 + 0.64 * side) * radius, 2 * radius, alpha));
  }
  scene.effects["inextensible"] = Switch::on;
  scene.effects["aggregation"] = potential(depth, distance, scaling);
  scene.numerics = numerics_at(resolution, 2 * radius);
  scene.numerics.time_step = 2e-5;
  scene.duration = 15e-3;
  Flow flow(scene);
  flow.finish();
  const Measurement run = flow.measurement();
  sum.simulated_time += run.simulated_time;
  sum.steps += run.steps;
  sum.particles = run.particles;
  const Scales& scales = flow.state().scales;
  return measured(flow.state(),
                  {depth / scales.tension(), distance / scales.length, scaling * scales.length});
}

/// Of cells that are bound to one another, where two within `reach` are.
int clusters(const effects::State& state, double reach) {
  const std::size_t n = state.cells.size();
  std::vector<std::size_t> cluster(n);
  for (std::size_t a = 0; a < n; ++a) cluster[a] = a;
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const cells::LinkBoxes one(state.ring(state.cells[a])), other(state.ring(state.cells[b]));
      if (cells::least_gap(one, other) > reach || cluster[a] == cluster[b]) continue;
      std::replace(cluster.begin(), cluster.end(), cluster[a], cluster[b]);
    }
  }
  std::sort(cluster.begin(), cluster.end());
  return static_cast<int>(std::unique(cluster.begin(), cluster.end()) - cluster.begin());
}

/// What is left of a stack of three cells after it was sheared by 12: one that does not hold is drawn
/// apart between 9 and 12.
int left_of_a_stack(double shear_rate, double depth, const Resolution& resolution, Measurement& sum) {
  constexpr double distance = 0.49e-6, scaling = 3.84e6, pitch = 2.9e-6;
  constexpr double length = 12 * radius, height = 6 * radius;
  Case scene;
  scene.vessel = {length, height};
  scene.vessel.ends = Ends::periodic;
  scene.vessel.wall_velocity = {-shear_rate * height / 2, shear_rate * height / 2};
  scene.inflow.velocity = scene.vessel.wall_velocity.upper;
  for (const int k : {-1, 0, 1}) scene.cells.push_back(upright(length / 2 + k * pitch, height / 2, 0.5));
  scene.effects["inextensible"] = Switch::on;
  scene.effects["aggregation"] = potential(depth, distance, scaling);
  scene.numerics = numerics_at(resolution, 2 * radius);
  scene.duration = 12 / shear_rate;
  Flow flow(scene);
  flow.finish();
  const Measurement run = flow.measurement();
  sum.simulated_time += run.simulated_time;
  sum.steps += run.steps;
  sum.particles = run.particles;
  return clusters(flow.state(), (distance + 3 / scaling) / flow.state().scales.length);
}

}  // namespace

Measurement run_adhering_vesicles(const Resolution& resolution) {
  const nlohmann::json& exact = reference("adhering_vesicles");
  Measurement m;
  for (const nlohmann::json& with : exact.at("pairs")) {
    const double adhesion = with.at("adhesion");
    const Adhered found = adhered(exact.at("alpha"), adhesion, resolution, m);
    const auto compare = [&](const char* name, double value) {
      const std::string full = std::string(name) + "_at_" + std::to_string(std::lround(adhesion));
      m.errors.emplace_back(full, std::abs(value / with.at(name).get<double>() - 1));
      m.values.emplace_back(full, value);
    };
    compare("contact", found.contact);
    compare("across", found.across);
    compare("along", found.along);
  }
  return m;
}

// Peeling two membranes apart takes a force of D for each depth, pulling them apart all at once D beta/2 for
// each area. Shear pulls with mu G for each area, over the length L of a cell. So a stack holds where
// mu G L is far below D, and does not where mu G exceeds D beta/2.
Measurement run_rouleau(const Resolution& resolution) {
  constexpr double depth = 1e-6, scaling = 3.84e6, viscosity = 1e-3, length = 8.7e-6;
  Measurement m;
  const int low = left_of_a_stack(0.2 * depth / (viscosity * length), depth, resolution, m);
  const int high = left_of_a_stack(2 * depth * scaling / 2 / viscosity, depth, resolution, m);
  m.errors = {{"breaks_at_low_shear", low > 1}, {"holds_at_high_shear", high < 2}};
  m.values = {{"clusters_at_low_shear", low}, {"clusters_at_high_shear", high}};
  return m;
}

}  // namespace rouleau::validation
