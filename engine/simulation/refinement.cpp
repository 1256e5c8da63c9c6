#include "engine/simulation/refinement.h"

#include <algorithm>
#include <cmath>

#include "engine/cells/resample.h"
#include "engine/cells/shape.h"
#include "engine/operators/sampler.h"
#include "engine/simulation/arrange.h"

namespace rouleau {

namespace {

using effects::CellState;
using effects::State;
using particles::Group;
using particles::ParticleSet;

/// Moves the nodes along their normals until the ring encloses `area`.
void inflate(std::vector<double>& x, std::vector<double>& y, double area) {
  for (int pass = 0; pass < 4; ++pass) {
    const cells::Ring ring{x, y};
    const double step = (area - cells::area(ring)) / cells::perimeter(ring);
    std::vector<double> moved_x = x, moved_y = y;
    for (std::size_t k = 0; k < x.size(); ++k) {
      const double tx = x[ring.next(k)] - x[ring.previous(k)], ty = y[ring.next(k)] - y[ring.previous(k)];
      const double length = std::hypot(tx, ty);
      moved_x[k] += step * ty / length;
      moved_y[k] -= step * tx / length;
    }
    x = moved_x;
    y = moved_y;
  }
}

/// Nodes anew, one spacing apart as the membrane is now: where it is stretched they had come far apart.
void transfer_cell(const State& from, const CellState& cell, int index, State& to) {
  const ParticleSet& old = from.particles;
  const cells::Ring ring = from.ring(cell);
  CellState finer = cell;
  finer.first_node = to.particles.size();
  // The fluid that is placed anew inside is counted on top of what a cell that deflates has lost.
  finer.circle_particles =
      static_cast<int>(std::lround((cell.circle_area - cell.start_area) / (to.spacing * to.spacing)));
  if (cell.departure) {
    to.cells.push_back(finer);
    return;
  }
  finer.nodes =
      std::max(cell.start_nodes, static_cast<int>(std::lround(cells::perimeter(ring) / to.spacing)));
  const std::vector<double> places = cells::equal_steps(cells::link_lengths(ring), finer.nodes);
  std::vector<double> rest_lengths = cell.material.rest_lengths;
  if (rest_lengths.empty()) rest_lengths.assign(cell.nodes, cell.material.rest_length);
  finer.material.rest_lengths = cells::between(rest_lengths, places);
  const auto carried = [&](const std::vector<double>& field) {
    return cells::interpolate({field.data() + cell.first_node, static_cast<std::size_t>(cell.nodes)}, places);
  };
  auto x = carried(old.x), y = carried(old.y);
  inflate(x, y, cells::area(ring));
  const auto u = carried(old.u), v = carried(old.v), p = carried(old.p);
  for (int q = 0; q < finer.nodes; ++q) {
    const int i = to.particles.add(Group::membrane, x[q], y[q], index);
    to.particles.u[i] = u[q];
    to.particles.v[i] = v[q];
    to.particles.p[i] = p[q];
  }
  to.cells.push_back(finer);
}

/// The mean of what the particles on the same side make of the pressure there.
class PressureOnASide {
 public:
  PressureOnASide(const State& state, const operators::Sampler& sampler) : state_(state), sampler_(sampler) {
    state.operators.pressure_gradients(state.particles.p.data(), gradients_);
  }

  double at(double x, double y, int cell) {
    const ParticleSet& particles = state_.particles;
    sampler_.find(x, y, particles.active_end(), found_);
    double weight = 0, sum = 0;
    for (const operators::SampledParticle& q : found_) {
      if (q.index < particles.membrane_end() || particles.cell[q.index] != cell) continue;
      const double w = q.weight * q.weight;
      weight += w;
      sum += w * (particles.p[q.index] -
                  state_.radius * (gradients_[2 * q.index] * q.dx + gradients_[2 * q.index + 1] * q.dy));
    }
    return weight > 0 ? sum / weight : 0;
  }

 private:
  const State& state_;
  const operators::Sampler& sampler_;
  std::vector<double> gradients_;
  std::vector<operators::SampledParticle> found_;
};

struct Momentum {
  double x = 0, y = 0;
};

Momentum momentum_of(const State& state, int end) {
  Momentum sum;
  const double mass = state.spacing * state.spacing;
  for (int i = 0; i < end; ++i) {
    sum.x += mass * state.particles.u[i];
    sum.y += mass * state.particles.v[i];
  }
  return sum;
}

void transfer_flow(const State& from, State& to) {
  const geometry::Bounds b = from.outline.bounds();
  const operators::Sampler sampler(from.particles,
                                   {from.radius, from.outline.period_x(), from.outline.period_y()},
                                   {b.x0, b.y0, b.x1, b.y1});
  PressureOnASide pressure(from, sampler);
  ParticleSet& particles = to.particles;
  for (int i = 0; i < particles.size(); ++i) {
    if (particles.group[i] != Group::fluid) continue;
    const operators::Velocity velocity = sampler.velocity(particles.x[i], particles.y[i]);
    particles.u[i] = velocity.u;
    particles.v[i] = velocity.v;
    particles.p[i] = pressure.at(particles.x[i], particles.y[i], particles.cell[i]);
  }
}

/// An even change of all velocities: it has no divergence and no strain of its own but at walls.
void keep_momentum(const State& from, State& to) {
  const int all = to.particles.size();
  const Momentum before = momentum_of(from, from.particles.active_end()), after = momentum_of(to, all);
  const double mass = all * to.spacing * to.spacing;
  for (int i = 0; i < all; ++i) {
    to.particles.u[i] += (before.x - after.x) / mass;
    to.particles.v[i] += (before.y - after.y) / mass;
  }
}

}  // namespace

State refined(const State& state, double spacing) {
  State finer(state.scene, state.scales, spacing, state.start_spacing);
  finer.time = state.time;
  finer.step = state.step;
  finer.speed = state.speed;
  finer.counters = state.counters;
  finer.particles.continue_ids(state.particles);
  for (std::size_t k = 0; k < state.cells.size(); ++k) {
    transfer_cell(state, state.cells[k], static_cast<int>(k), finer);
  }
  place_fluid(finer);
  transfer_flow(state, finer);
  keep_momentum(state, finer);
  place_walls(finer);
  return finer;
}

}  // namespace rouleau
