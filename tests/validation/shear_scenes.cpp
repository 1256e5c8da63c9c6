#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "engine/cells/shape.h"
#include "engine/cells/tank_treading.h"
#include "tests/validation/flow.h"
#include "tests/validation/references.h"

namespace rouleau::validation {

namespace {

constexpr double radius = 3.18e-6;   // of the circle that the unstretched membrane would be
constexpr double shear_rate = 150;   // 1/s: a Reynolds number of 1.5e-3, the references have none
constexpr double box = 16 * radius;  // at twice that deformations are the same within 1 %
constexpr double viscosity = 1e-3;   // of the plasma, Pa s
constexpr double stiff = 20000;      // E_s R^2/B: the perimeter grows by 0.1 %

/// (L - W)/(L + W) of the ellipse whose principal moments are in the ratio of those of the enclosed area.
double deformation(cells::Ring ring, const cells::Shape& shape) {
  double xx = 0, yy = 0, xy = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t j = ring.next(i);
    const double xi = ring.x[i] - shape.x, yi = ring.y[i] - shape.y;
    const double xj = ring.x[j] - shape.x, yj = ring.y[j] - shape.y;
    const double twice = xi * yj - xj * yi;
    xx += twice * (xi * xi + xi * xj + xj * xj);
    yy += twice * (yi * yi + yi * yj + yj * yj);
    xy += twice * (xi * yi + (xi * yj + xj * yi) / 2 + xj * yj);
  }
  const double mean = (xx + yy) / 2, half_difference = std::hypot((xx - yy) / 2, xy);
  const double l = std::sqrt(mean + half_difference), w = std::sqrt(mean - half_difference);
  return (l - w) / (l + w);
}

/// What is seen of the cell, on average over some time.
struct Seen {
  double deformation = 0;
  double inclination = 0;      ///< of the long axis to the walls, in pi
  double perimeter = 0;        ///< over that at the start
  double period = 0;           ///< of tank-treading, in 1/G
  double length_error = 0;     ///< of held links, the greatest of |l / l0 - 1|
  double perimeter_error = 0;  ///< the greatest of |perimeter over that at the start - 1|
};

/// A cell in the middle of a periodic vessel whose walls move. Times are in 1/G.
class ShearFlow {
 public:
  ShearFlow(RedCell cell, const Resolution& resolution, double duration, bool held = false)
      : flow_(scene_of(cell, resolution, duration, held)), start_perimeter_(shape().perimeter) {}

  double inclination() const { return shape().angle / 180; }
  double time() const { return flow_.time() * shear_rate; }
  bool finished() const { return flow_.finished(); }
  void step() { flow_.step(); }
  Measurement measurement() const { return flow_.measurement(); }

  /// Steps until this time.
  Seen average_to(double end) {
    Seen sum;
    double turned = 0, phase = this->phase(), start = time();
    while (!finished() && time() < end * (1 - 1e-9)) {
      const double before = time();
      step();
      const double dt = time() - before;
      const cells::Shape now = shape();
      sum.deformation += dt * deformation(ring(), now);
      sum.inclination += dt * now.angle / 180;
      sum.perimeter += dt * now.perimeter / start_perimeter_;
      sum.length_error = std::max(sum.length_error, length_error());
      sum.perimeter_error = std::max(sum.perimeter_error, std::abs(now.perimeter / start_perimeter_ - 1));
      turned += cells::axis_angle(this->phase() - phase);
      phase = this->phase();
    }
    const double span = time() - start;
    return {sum.deformation / span,        sum.inclination / span, sum.perimeter / span,
            360 * span / std::abs(turned), sum.length_error,       sum.perimeter_error};
  }

 private:
  static Case scene_of(RedCell cell, const Resolution& resolution, double duration, bool held) {
    Case scene;
    scene.vessel = {box, box};
    scene.vessel.ends = Ends::periodic;
    scene.vessel.wall_velocity = {-shear_rate * box / 2, shear_rate * box / 2};
    scene.inflow.velocity = scene.vessel.wall_velocity.upper;
    cell.x = cell.y = box / 2;
    cell.diameter = 2 * radius;
    scene.cells = {cell};
    if (held) scene.effects["inextensible"] = Switch::on;
    scene.numerics = numerics_at(resolution, 2 * radius);
    scene.duration = duration / shear_rate;
    return scene;
  }

  cells::Ring ring() const { return flow_.state().ring(flow_.state().cells.front()); }
  cells::Shape shape() const { return cells::measure(ring()); }
  double length_error() const {
    const effects::CellState& cell = flow_.state().cells.front();
    return cell.held.length.empty() ? 0 : cells::greatest_length_error(ring(), cell.held);
  }
  /// Of tank-treading, in degrees.
  double phase() const {
    const effects::CellState& cell = flow_.state().cells.front();
    const auto of_cell = [&](const std::vector<double>& velocity) {
      return std::span(velocity).subspan(cell.first_node, cell.nodes);
    };
    const auto& particles = flow_.state().particles;
    return cells::tank_treading(ring(), of_cell(particles.u), of_cell(particles.v)).phase;
  }

  Flow flow_;
  double start_perimeter_;
};

/// Its membrane hardly stretches, and Ca = mu G R^3/B = 10.
RedCell vesicle(double alpha, double viscosity_ratio, double inclination) {
  RedCell cell;
  cell.fill = alpha;
  cell.bend_modulus = viscosity * shear_rate * std::pow(radius, 3) / 10;
  cell.stretch_modulus = stiff * cell.bend_modulus / (radius * radius);
  cell.viscosity_ratio = viscosity_ratio;
  cell.angle = 180 * inclination;
  return cell;
}

/// Whether it turns over, from an inclination of 0. One that is to tank-tread rises from there.
bool tumbles(double alpha, double viscosity_ratio, const Resolution& resolution, Measurement& sum) {
  constexpr double duration = 20;
  ShearFlow flow(vesicle(alpha, viscosity_ratio, 0), resolution, duration);
  while (!flow.finished() && flow.inclination() > -0.25) flow.step();
  const Measurement run = flow.measurement();
  sum.simulated_time += run.simulated_time;
  sum.steps += run.steps;
  sum.particles = run.particles;
  return flow.inclination() <= -0.25;
}

}  // namespace

Measurement run_ring(const Resolution& resolution, const std::string& name) {
  const nlohmann::json& exact = reference("elastic_ring_in_shear").at(name);
  RedCell cell;
  cell.fill = 1;
  cell.stretch_modulus = viscosity * shear_rate * radius / exact.at("Ca").get<double>();
  // The case has no membrane without bending: a billionth of the stretch modulus is as good as none.
  const double bending = std::max(exact.at("Bn").get<double>(), 1e-9);
  cell.bend_modulus = bending * cell.stretch_modulus * radius * radius;
  ShearFlow flow(cell, resolution, 9);
  flow.average_to(7);
  const Seen seen = flow.average_to(9);
  Measurement m = flow.measurement();
  const auto compare = [&](const nlohmann::json& with, const std::string& suffix) {
    const auto off = [&](double value, const char* of) {
      return std::abs(value / with.at(of).get<double>() - 1);
    };
    m.errors.emplace_back("deformation" + suffix, off(seen.deformation, "deformation"));
    m.errors.emplace_back("inclination_over_pi" + suffix,
                          std::abs(seen.inclination - with.at("inclination").get<double>()));
    m.errors.emplace_back("perimeter" + suffix, off(seen.perimeter, "perimeter"));
  };
  compare(exact, "");
  if (exact.contains("conservative")) compare(exact.at("conservative"), "_conservative");
  m.values = {{"deformation", seen.deformation},
              {"inclination_over_pi", seen.inclination},
              {"perimeter", seen.perimeter}};
  return m;
}

// From the reference's inclination, so that little is to settle. Near the threshold of tumbling that takes
// long.
Measurement run_vesicle(const Resolution& resolution, const std::string& name, bool held) {
  const nlohmann::json& exact = reference("vesicle_in_shear").at(name);
  const double ratio = exact.value("viscosity_ratio", 1.0), inclination = exact.at("inclination");
  const double settled = ratio > 1 ? 10 : 2, end = settled + 3;
  ShearFlow flow(vesicle(exact.at("alpha"), ratio, inclination), resolution, end, held);
  const Seen settling = flow.average_to(settled);
  const Seen seen = flow.average_to(end);
  Measurement m = flow.measurement();
  m.errors = {{"inclination_over_pi", std::abs(seen.inclination - inclination)}};
  m.values = {{"inclination_over_pi", seen.inclination},
              {"perimeter_error", std::max(settling.perimeter_error, seen.perimeter_error)}};
  if (held) m.values.emplace_back("length_error", std::max(settling.length_error, seen.length_error));
  if (exact.contains("period")) {
    m.errors.emplace_back("period", std::abs(seen.period / exact.at("period").get<double>() - 1));
    m.errors.emplace_back("deformation",
                          std::abs(seen.deformation / exact.at("deformation").get<double>() - 1));
    m.values.emplace_back("period", seen.period);
    m.values.emplace_back("deformation", seen.deformation);
  }
  return m;
}

Measurement run_tumbling(const Resolution& resolution) {
  const nlohmann::json& exact = reference("vesicle_in_shear").at("tumbling");
  const double alpha = exact.at("alpha"), treads = exact.at("still_treads"), width = 0.5;
  Measurement m;
  double low = treads;
  while (tumbles(alpha, low, resolution, m)) low -= width;
  if (low == treads) {
    while (!tumbles(alpha, low + width, resolution, m)) low += width;
  }
  m.errors = {{"threshold_off_by", std::abs(low - treads)}};
  m.values = {{"still_treads", low}, {"tumbles", low + width}};
  return m;
}

}  // namespace rouleau::validation
