#include "engine/simulation/refinement.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "engine/cells/offset.h"
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
  std::vector<double> moved_x, moved_y;
  for (int pass = 0; pass < 4; ++pass) {
    const cells::Ring ring{x, y};
    cells::offset(ring, (area - cells::area(ring)) / cells::perimeter(ring), moved_x, moved_y);
    x.swap(moved_x);
    y.swap(moved_y);
  }
}

/// Nodes anew, one spacing of `to` apart as the membrane is now: where it is stretched they had come far
/// apart.
void transfer_cell(const ParticleSet& old, const CellState& cell, int index, State& to) {
  CellState renewed = cell;
  renewed.first_node = to.particles.size();
  if (cell.departure) {
    to.cells.push_back(renewed);
    return;
  }
  const auto of_cell = [&](const std::vector<double>& field) {
    return std::span<const double>(field).subspan(cell.first_node, cell.nodes);
  };
  const cells::Ring ring{of_cell(old.x), of_cell(old.y)};
  renewed.nodes =
      std::max(cell.start_nodes, static_cast<int>(std::lround(cells::perimeter(ring) / to.spacing)));
  const std::vector<double> places = cells::equal_steps(cells::link_lengths(ring), renewed.nodes);
  std::vector<double> rest_lengths = cell.material.rest_lengths;
  if (rest_lengths.empty()) rest_lengths.assign(cell.nodes, cell.material.rest_length);
  renewed.material.rest_lengths = cells::between(rest_lengths, places);
  if (!cell.held.length.empty()) renewed.held = {{}, cells::interpolate(cell.held.tension, places)};
  const auto carried = [&](const std::vector<double>& field) {
    return cells::interpolate(of_cell(field), places);
  };
  auto x = carried(old.x), y = carried(old.y);
  inflate(x, y, cells::area(ring));
  const auto u = carried(old.u), v = carried(old.v), p = carried(old.p);
  for (int q = 0; q < renewed.nodes; ++q) {
    const int i = to.particles.add(Group::membrane, x[q], y[q], index);
    to.particles.u[i] = u[q];
    to.particles.v[i] = v[q];
    to.particles.p[i] = p[q];
  }
  to.cells.push_back(renewed);
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
    transfer_cell(state.particles, state.cells[k], static_cast<int>(k), finer);
    // The fluid that is placed anew inside is counted on top of what a cell that deflates has lost.
    CellState& cell = finer.cells.back();
    const double lost = cell.circle_area - cell.start_area;
    cell.circle_particles = static_cast<int>(std::lround(lost / (finer.spacing * finer.spacing)));
  }
  place_fluid(finer);
  transfer_flow(state, finer);
  keep_momentum(state, finer);
  place_walls(finer);
  return finer;
}

void renew_nodes(State& state) {
  const ParticleSet old = std::exchange(state.particles, {});
  const std::vector<CellState> cells = std::exchange(state.cells, {});
  state.particles.continue_ids(old);
  for (std::size_t k = 0; k < cells.size(); ++k) transfer_cell(old, cells[k], static_cast<int>(k), state);
  for (int i = old.membrane_end(); i < old.size(); ++i) state.particles.add_from(old, i);
}

}  // namespace rouleau
