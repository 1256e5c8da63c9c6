#include <benchmark/benchmark.h>

#include "engine/linear/aggregates.h"
#include "engine/linear/two_level_cg.h"
#include "engine/operators/least_squares.h"
#include "engine/particles/neighbour_list.h"
#include "tests/unit/engine/operators/disordered_vessel.h"

namespace rouleau {
namespace {

constexpr double spacing = 0.04;

/// A vessel 25 spacings wide with about `range(0)` particles, everything in it up to date.
struct Vessel {
  explicit Vessel(const benchmark::State& state)
      : length(static_cast<double>(state.range(0)) / 24 * spacing),
        particles(operators::disordered_vessel(length, spacing, 0.3, 1)),
        list({-10 * spacing, -10 * spacing, length + 10 * spacing, 1 + 10 * spacing}, 3.1 * spacing,
             2.1 * spacing) {
    list.sort(particles);
    list.build(particles);
    fit.build(particles, list);
    operators::interleave(particles.x, particles.y, velocity);
  }

  void count(benchmark::State& state) const {
    state.SetItemsProcessed(state.iterations() * particles.active_end());
  }

  double length;
  particles::ParticleSet particles;
  particles::NeighbourList list;
  operators::LeastSquares fit;
  std::vector<double> velocity;
};

void sort(benchmark::State& state) {
  Vessel vessel(state);
  for (auto _ : state) vessel.list.sort(vessel.particles);
  vessel.count(state);
}

void search(benchmark::State& state) {
  Vessel vessel(state);
  for (auto _ : state) vessel.list.build(vessel.particles);
  vessel.count(state);
}

void least_squares(benchmark::State& state) {
  Vessel vessel(state);
  for (auto _ : state) vessel.fit.build(vessel.particles, vessel.list);
  vessel.count(state);
}

void pressure_gradient(benchmark::State& state) {
  Vessel vessel(state);
  std::vector<double> out;
  for (auto _ : state) vessel.fit.pressure_gradients(vessel.particles.x.data(), out);
  vessel.count(state);
}

void divergence(benchmark::State& state) {
  Vessel vessel(state);
  std::vector<double> out;
  for (auto _ : state) vessel.fit.divergences(vessel.velocity.data(), out);
  vessel.count(state);
}

void viscous_product(benchmark::State& state) {
  Vessel vessel(state);
  const std::vector<float> velocity(vessel.velocity.begin(), vessel.velocity.end());
  std::vector<float> out(2 * static_cast<std::size_t>(vessel.particles.active_end()));
  for (auto _ : state) vessel.fit.laplacian_products(velocity.data(), out.data());
  vessel.count(state);
}

/// The graph Laplacian of the near pairs, held at the vessel's ends.
void conjugate_gradients(benchmark::State& state) {
  const Vessel vessel(state);
  const int n = vessel.particles.active_end();
  linear::SparseRows matrix;
  matrix.clear();
  for (int i = 0; i < n; ++i) {
    int near = 0;
    for (int k = vessel.list.begin(i); k < vessel.list.near_end(i); ++k) {
      const int j = vessel.list.j[k];
      if (j >= vessel.particles.pressure_end()) continue;
      ++near;
      if (j < n) matrix.add(j, -1);
    }
    matrix.end_row(near);
  }
  const auto rows = static_cast<std::size_t>(n);
  linear::GridAggregates grid(5 * spacing, 0, 0);
  const auto& aggregates = grid.build({vessel.particles.x.data(), rows}, {vessel.particles.y.data(), rows});
  std::vector<double> right(rows), x(rows);
  for (std::size_t i = 0; i < rows; ++i) right[i] = static_cast<double>(i % 7) - 3;
  linear::TwoLevelCg solver;
  double iterations = 0;
  for (auto _ : state) {
    x.assign(rows, 0);
    solver.prepare(matrix, aggregates);
    iterations += solver.solve(right, x, 1e-2, 500).iterations;
  }
  vessel.count(state);
  state.counters["iterations"] = iterations / static_cast<double>(state.iterations());
}

BENCHMARK(sort)->Arg(1000)->Arg(5000)->Arg(50000);
BENCHMARK(search)->Arg(1000)->Arg(5000)->Arg(50000);
BENCHMARK(least_squares)->Arg(1000)->Arg(5000)->Arg(50000);
BENCHMARK(pressure_gradient)->Arg(1000)->Arg(5000)->Arg(50000);
BENCHMARK(divergence)->Arg(1000)->Arg(5000)->Arg(50000);
BENCHMARK(viscous_product)->Arg(1000)->Arg(5000)->Arg(50000);
BENCHMARK(conjugate_gradients)->Arg(1000)->Arg(5000)->Arg(50000);

}  // namespace
}  // namespace rouleau

BENCHMARK_MAIN();
