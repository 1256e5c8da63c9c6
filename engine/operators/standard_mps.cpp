#include "engine/operators/standard_mps.h"

#include <cmath>

namespace rouleau::operators {

namespace {

void weigh(const StandardMps& mps, const std::vector<float>& distances, std::vector<float>& weights) {
  weights.resize(distances.size());
  for (std::size_t k = 0; k < distances.size(); ++k) {
    weights[k] = static_cast<float>(mps.weight(distances[k]));
  }
}

}  // namespace

StandardMps::StandardMps(double spacing, double radius) : radius_(radius) {
  const int reach = static_cast<int>(radius / spacing) + 1;
  for (int a = -reach; a <= reach; ++a) {
    for (int b = -reach; b <= reach; ++b) {
      if (a == 0 && b == 0) continue;
      const double r = spacing * std::hypot(a, b);
      density_ += weight(r);
      lambda_ += weight(r) * r * r;
    }
  }
  lambda_ /= density_;
}

void KernelWeights::fill(const StandardMps& mps, const particles::NeighbourList& list) {
  weigh(mps, list.r, pair);
  weigh(mps, list.ghost_r, ghost);
}

double number_density(const particles::NeighbourList& list, const KernelWeights& weights, int i) {
  double sum = 0;
  for (int k = list.begin(i); k < list.end(i); ++k) sum += weights.pair[k];
  for (int k = list.ghost_begin(i); k < list.ghost_end(i); ++k) sum += weights.ghost[k];
  return sum;
}

Gradient gradient(const StandardMps& mps, const particles::NeighbourList& list, const KernelWeights& weights,
                  int i, const double* field, double base) {
  Gradient sum;
  for (int k = list.begin(i); k < list.end(i); ++k) {
    const double r = list.r[k];
    const double slope = weights.pair[k] * (field[list.j[k]] - base) / (r * r);
    sum.x += slope * list.dx[k];
    sum.y += slope * list.dy[k];
  }
  return {mps.gradient_scale() * sum.x, mps.gradient_scale() * sum.y};
}

double divergence(const StandardMps& mps, const particles::NeighbourList& list, const KernelWeights& weights,
                  int i, const double* u, const double* v) {
  double sum = 0;
  for (int k = list.begin(i); k < list.end(i); ++k) {
    const double r = list.r[k];
    const int j = list.j[k];
    sum += weights.pair[k] / (r * r) * ((u[j] - u[i]) * list.dx[k] + (v[j] - v[i]) * list.dy[k]);
  }
  return mps.gradient_scale() * sum;
}

double laplacian(const StandardMps& mps, const particles::NeighbourList& list, const KernelWeights& weights,
                 int i, const double* field) {
  double sum = 0;
  for (int k = list.begin(i); k < list.end(i); ++k) {
    sum += weights.pair[k] * (field[list.j[k]] - field[i]);
  }
  for (int k = list.ghost_begin(i); k < list.ghost_end(i); ++k) {
    sum += weights.ghost[k] * (field[list.ghost[k]] - field[i]);
  }
  return mps.laplacian_scale() * sum;
}

}  // namespace rouleau::operators
