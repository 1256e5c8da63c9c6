#include "engine/observe/wall_shear.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Dense>

#include "engine/observe/fluid_segments.h"

namespace rouleau::observe {

namespace {

using geometry::WallPiece;
using Matrix = Eigen::Matrix4d;
using Vector = Eigen::Vector4d;

// In spacings: by how much a particle's distance from this piece may differ from that from all walls.
constexpr double same_wall = 1e-6;
// Of the normal equations, smallest over largest: below it they do not carry all four terms.
constexpr double least_pivot = 1e-6;

double length_of(const WallPiece& piece) {
  return piece.radius > 0 ? std::numbers::pi * piece.radius
                          : std::hypot(piece.to[0] - piece.from[0], piece.to[1] - piece.from[1]);
}

/// Odd on an arc, so that a node stands on its crest.
int nodes_on(const WallPiece& piece, double spacing) {
  const int count = std::max(1, static_cast<int>(std::lround(length_of(piece) / spacing)));
  return piece.radius > 0 ? count | 1 : count;
}

/// Whether a wall is run through against the flow: the upper one of a vessel.
bool runs_backwards(const geometry::WallChain& chain, double tolerance) {
  return std::none_of(chain.pieces.begin(), chain.pieces.end(),
                      [&](const WallPiece& piece) { return piece.to[0] - piece.from[0] > tolerance; });
}

/// A particle as a node's wall sees it.
struct NearWall {
  double along = 0, distance = 0;
  double tx = 1, ty = 0;  ///< along the wall at the particle's foot
};

/// (dx, dy) is the particle's place relative to the node. Arcs run clockwise about their centre.
NearWall seen_from(double tx, double ty, double radius, double dx, double dy) {
  const double along = dx * tx + dy * ty, out = dy * tx - dx * ty;
  if (radius == 0) return {along, out, tx, ty};
  const double angle = std::atan2(along, radius + out);
  const double c = std::cos(angle), s = std::sin(angle);
  return {radius * angle, std::hypot(along, radius + out) - radius, tx * c + ty * s, ty * c - tx * s};
}

operators::SamplingBox box_of(const geometry::Bounds& bounds) {
  return {bounds.x0, bounds.y0, bounds.x1, bounds.y1};
}

}  // namespace

WallShear::WallShear(const effects::State& state) : length_unit_(state.scales.length) {
  int number = 0;
  for (const geometry::WallChain& chain : state.outline.walls()) add_wall(chain, state.spacing, number++);
}

void WallShear::add_wall(const geometry::WallChain& chain, double spacing, int number) {
  const auto first = static_cast<std::ptrdiff_t>(nodes_.size());
  double passed = 0;
  for (const WallPiece& piece : chain.pieces) {
    const double length = length_of(piece), chord_x = piece.to[0] - piece.from[0],
                 chord_y = piece.to[1] - piece.from[1], chord = std::hypot(chord_x, chord_y);
    const double cx = chord_x / chord, cy = chord_y / chord;
    const int count = nodes_on(piece, spacing);
    for (int k = 0; k < count; ++k) {
      const double part = (k + 0.5) / count;
      Node node{.x = piece.from[0] + part * chord_x, .y = piece.from[1] + part * chord_y, .tx = cx, .ty = cy};
      if (piece.radius > 0) {
        const double c = std::cos(std::numbers::pi * part), s = std::sin(std::numbers::pi * part);
        node.x = piece.centre[0] - piece.radius * (cx * c + cy * s);
        node.y = piece.centre[1] - piece.radius * (cy * c - cx * s);
        node.tx = cx * s - cy * c;
        node.ty = cy * s + cx * c;
      }
      node.radius = piece.radius;
      node.speed = piece.speed;
      const bool upright = std::abs(chord_x) < 1e-9 * chord;
      node.sign = (upright ? chord_y : chord_x) < 0 ? -1 : 1;
      node.arc_length = passed + part * length;
      node.wall = number;
      nodes_.push_back(node);
    }
    passed += length;
  }
  if (!runs_backwards(chain, 1e-9 * spacing)) return;
  std::reverse(nodes_.begin() + first, nodes_.end());
  for (auto node = nodes_.begin() + first; node != nodes_.end(); ++node) {
    node->arc_length = passed - node->arc_length;
  }
}

WallNodes WallShear::nodes() const {
  WallNodes described;
  for (const Node& node : nodes_) {
    described.x.push_back(node.x * length_unit_);
    described.y.push_back(node.y * length_unit_);
    described.nx.push_back(-node.ty);
    described.ny.push_back(node.tx);
    described.arc_length.push_back(node.arc_length * length_unit_);
    described.wall.push_back(node.wall);
  }
  return described;
}

double WallShear::slope(const effects::State& state, const Node& node,
                        const std::vector<operators::SampledParticle>& near, double reach) const {
  const auto& particles = state.particles;
  Matrix normal = Matrix::Zero();
  Vector right = Vector::Zero();
  for (const auto& q : near) {
    const NearWall at = seen_from(node.tx, node.ty, node.radius, q.dx * reach, q.dy * reach);
    const double nearest = state.outline.distance(particles.x[q.index], particles.y[q.index]).value;
    if (std::abs(at.distance - nearest) > same_wall * state.spacing) continue;
    const double n = at.distance / reach, s = at.along / reach;
    const Vector basis(n, n * s, n * n, n * s * s);
    const double along = particles.u[q.index] * at.tx + particles.v[q.index] * at.ty - node.speed;
    normal += q.weight * basis * basis.transpose();
    right += q.weight * along * basis;
  }
  if (normal(0, 0) <= 0) return std::numeric_limits<double>::quiet_NaN();
  // In units in which the diagonal is 1.
  const Vector scale = normal.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::LDLT<Matrix> factor(scale.asDiagonal() * normal * scale.asDiagonal());
  if (factor.vectorD().minCoeff() < least_pivot) return right(0) / normal(0, 0) / reach;
  return scale(0) * factor.solve(scale.cwiseProduct(right))(0) / reach;
}

std::vector<float> WallShear::stress(const effects::State& state) const {
  std::vector<float> stress;
  const operators::SamplingReach reach = sampling_reach(state);
  const operators::Sampler sampler(state.particles, reach, box_of(state.outline.bounds()));
  std::vector<operators::SampledParticle> near;
  for (const Node& node : nodes_) {
    sampler.find(node.x, node.y, state.particles.pressure_end(), near);
    const double slope_here = node.sign * slope(state, node, near, reach.radius);
    stress.push_back(static_cast<float>(state.viscosity * slope_here * state.scales.pressure()));
  }
  return stress;
}

const ObserverKind wall_shear_stress{
    "wall_shear_stress",
    false,
    [](const Case& scene) {
      if (scene.output.frame_interval <= 0) {
        return effects::Need{false, "no frames are asked for", "/output/frame_interval"};
      }
      const bool asked = carries(scene, Field::wall_shear_stress);
      return effects::Need{asked, asked ? "frames carry the stress on the walls" : "no frame carries it",
                           "/output/fields"};
    },
    [](const effects::State& start, const CellFreeFlow&) -> std::unique_ptr<Observer> {
      return std::make_unique<WallShear>(start);
    },
    nullptr,
    {},
    {.frame = {.wall_node = 500}}};

}  // namespace rouleau::observe
