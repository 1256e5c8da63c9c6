#include "engine/cells/rest_shape.h"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "engine/cells/ellipse.h"
#include "engine/cells/energy_minimisation.h"
#include "engine/cells/shape.h"

namespace rouleau::cells {
namespace {

using Nodes = EnergyMinimisation::Nodes;

void check(const Material& material, int nodes, double area) {
  if (!(material.stretch_modulus > 0.0 && material.bend_modulus > 0.0 && material.rest_length > 0.0)) {
    throw RestShapeError("rest shape: moduli and rest length must be positive");
  }
  if (nodes < 8) throw RestShapeError("rest shape: at least 8 nodes, not " + std::to_string(nodes));
  if (!(area > 0.0)) throw RestShapeError("rest shape: the area must be positive");
}

Nodes regular_polygon(int nodes, double area) {
  const double turn = 2.0 * std::numbers::pi / nodes;
  const double radius = std::sqrt(2.0 * area / (nodes * std::sin(turn)));
  Nodes polygon(2, nodes);
  for (int i = 0; i < nodes; ++i) {
    polygon.col(i) << radius * std::cos((i + 0.5) * turn), radius * std::sin((i + 0.5) * turn);
  }
  return polygon;
}

Nodes flattened(int nodes, double area) {
  const Ellipse ellipse = ellipse_of(nodes, area, nodes);
  Nodes start(2, nodes);
  start.row(0) = Eigen::Map<const Eigen::RowVectorXd>(ellipse.x.data(), nodes);
  start.row(1) = Eigen::Map<const Eigen::RowVectorXd>(ellipse.y.data(), nodes);
  return start;
}

RestShape describe(const Nodes& nodes, double unit, int iterations) {
  std::vector<double> x, y;
  for (const auto& node : nodes.colwise()) {
    x.push_back(unit * node.x());
    y.push_back(unit * node.y());
  }
  const Shape shape = measure({x, y});
  for (double& value : x) value -= shape.x;
  for (double& value : y) value -= shape.y;
  return {std::move(x), std::move(y), shape.area, shape.perimeter, iterations};
}

}  // namespace

RestShape rest_shape(const Material& material, int nodes, double area) {
  check(material, nodes, area);
  const double unit = material.rest_length;
  const double scaled_area = area / (unit * unit);
  const double unstretched = nodes / (4.0 * std::tan(std::numbers::pi / nodes));
  if (scaled_area >= unstretched) return describe(regular_polygon(nodes, scaled_area), unit, 0);

  const Material scaled{1.0, material.bend_modulus / (material.stretch_modulus * unit * unit), 1.0,
                        material.crush_stiffening};
  EnergyMinimisation minimisation(scaled, scaled_area, flattened(nodes, scaled_area));
  const int iterations = minimisation.run();
  const std::string request = std::to_string(nodes) + " nodes at " +
                              std::to_string(scaled_area / unstretched) + " of the unstretched area";
  if (iterations < 0) throw RestShapeError("rest shape: no convergence with " + request);
  const Nodes result = minimisation.nodes();
  if ((result.row(1).head(nodes / 2).array() <= 0.0).any()) {
    throw RestShapeError("rest shape: the two sides would cross with " + request);
  }
  return describe(result, unit, iterations);
}

}  // namespace rouleau::cells
