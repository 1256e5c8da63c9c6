#include "engine/observe/fluid_segments.h"

#include <algorithm>
#include <cmath>

namespace rouleau::observe {

namespace {

// In spacings: how near to a wall or an end counts as on it, how finely a line is searched, and the
// shortest part of it that is measured.
constexpr double contact = 1e-6;
constexpr double search = 0.25;
constexpr double shortest = 1e-3;
constexpr int bisections = 40;
// In spacings: the published scheme's kernel is too narrow for a quadratic.
constexpr double least_radius = 3.1;

Point between(const Point& from, const Point& to, double s) {
  return {from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1])};
}

double distance(const Point& from, const Point& to) {
  return std::hypot(to[0] - from[0], to[1] - from[1]);
}

operators::SamplingPlane segment(const effects::State& state, const Point& from, const Point& to) {
  const double spacings = std::ceil(distance(from, to) / state.spacing - contact);
  return {from, to, sampling_reach(state), 2 * std::max(1, static_cast<int>(spacings))};
}

}  // namespace

bool in_fluid(const effects::State& state, const Point& point) {
  const double t = contact * state.spacing;
  const auto& [x, y] = point;
  const geometry::Outline& outline = state.outline;
  return outline.contains(x, y) || outline.contains(x - t, y - t) || outline.contains(x + t, y - t) ||
         outline.contains(x - t, y + t) || outline.contains(x + t, y + t);
}

std::vector<operators::SamplingPlane> fluid_segments(const effects::State& state, const Point& from,
                                                     const Point& to) {
  std::vector<operators::SamplingPlane> segments;
  const double whole = distance(from, to);
  if (whole <= 0) return segments;
  const auto inside = [&](double s) { return in_fluid(state, between(from, to, s)); };
  const auto boundary = [&](double in, double out) {
    for (int k = 0; k < bisections; ++k) {
      const double middle = (in + out) / 2;
      (inside(middle) ? in : out) = middle;
    }
    return in;
  };
  const int steps = std::max(1, static_cast<int>(std::ceil(whole / (search * state.spacing))));
  bool was_inside = inside(0);
  double begin = 0;
  const auto close_at = [&](double end) {
    if ((end - begin) * whole > shortest * state.spacing) {
      segments.push_back(segment(state, between(from, to, begin), between(from, to, end)));
    }
  };
  for (int k = 1; k <= steps; ++k) {
    const double s = static_cast<double>(k) / steps, before = static_cast<double>(k - 1) / steps;
    const bool is_inside = inside(s);
    if (is_inside && !was_inside) begin = boundary(s, before);
    if (!is_inside && was_inside) close_at(boundary(before, s));
    was_inside = is_inside;
  }
  if (was_inside) close_at(1);
  return segments;
}

operators::CrossSection measure(const particles::ParticleSet& particles,
                                std::span<const operators::SamplingPlane> segments) {
  operators::CrossSection all;
  double width = 0;
  for (const auto& plane : segments) {
    const operators::CrossSection section = operators::measure(particles, plane);
    all.flux += section.flux;
    all.pressure += section.pressure * operators::length(plane);
    width += operators::length(plane);
  }
  if (width > 0) all.pressure /= width;
  return all;
}

double total_flux(const particles::ParticleSet& particles,
                  std::span<const operators::SamplingPlane> segments) {
  double sum = 0;
  for (const auto& plane : segments) sum += operators::measure_flux(particles, plane);
  return sum;
}

operators::SamplingReach sampling_reach(const effects::State& state) {
  return {std::max(state.radius, least_radius * state.spacing), state.outline.period_x(),
          state.outline.period_y()};
}

}  // namespace rouleau::observe
