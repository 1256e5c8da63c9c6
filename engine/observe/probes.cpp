#include "engine/observe/probes.h"

#include <algorithm>
#include <limits>

#include "engine/observe/fluid_segments.h"

namespace rouleau::observe {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

operators::SamplingBox box_of(const std::vector<Point>& points) {
  operators::SamplingBox box{points[0][0], points[0][1], points[0][0], points[0][1]};
  for (const auto& [x, y] : points) {
    box = {std::min(box.x0, x), std::min(box.y0, y), std::max(box.x1, x), std::max(box.y1, y)};
  }
  return box;
}

}  // namespace

Probes::Probes(const effects::State& state) : length_unit_(state.scales.length) {
  for (const Probe& probe : state.scene.probes) {
    Line line;
    line.name = probe.name;
    const Point from{probe.from[0] / length_unit_, probe.from[1] / length_unit_};
    const Point to{probe.to[0] / length_unit_, probe.to[1] / length_unit_};
    line.is_point = from == to;
    for (int k = 0; k < probe.points; ++k) {
      const double s = probe.points > 1 ? static_cast<double>(k) / (probe.points - 1) : 0;
      line.points.push_back({from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1])});
      line.inside.push_back(in_fluid(state, line.points.back()));
    }
    line.segments = fluid_segments(state, from, to);
    lines_.push_back(std::move(line));
  }
}

std::vector<ProbeLine> Probes::lines() const {
  std::vector<ProbeLine> lines;
  for (const Line& line : lines_) {
    ProbeLine& described = lines.emplace_back();
    described.name = line.name;
    described.has_flux = !line.is_point;
    for (const Point& point : line.points) {
      described.x.push_back(point[0] * length_unit_);
      described.y.push_back(point[1] * length_unit_);
    }
  }
  return lines;
}

std::vector<ProbeValues> Probes::values(const effects::State& state) const {
  std::vector<ProbeValues> values;
  for (const Line& line : lines_) {
    const operators::Sampler sampler(state.particles, sampling_reach(state), box_of(line.points));
    ProbeValues& sampled = values.emplace_back();
    for (std::size_t k = 0; k < line.points.size(); ++k) {
      const auto& [x, y] = line.points[k];
      const bool inside = line.inside[k];
      const operators::Velocity velocity =
          inside ? sampler.velocity(x, y) : operators::Velocity{nothing, nothing};
      sampled.u.push_back(velocity.u * state.scales.velocity);
      sampled.v.push_back(velocity.v * state.scales.velocity);
      sampled.p.push_back((inside ? sampler.pressure(x, y) : nothing) * state.scales.pressure());
    }
    sampled.flux = total_flux(state.particles, line.segments) * state.scales.flux();
  }
  return values;
}

const ObserverKind probes{
    "probes",
    false,
    [](const Case& scene) {
      const bool asked = !scene.probes.empty();
      return effects::Need{asked, asked ? "the case has probes" : "the case has no probes", "/probes"};
    },
    [](const effects::State& start, const CellFreeFlow&) -> std::unique_ptr<Observer> {
      return std::make_unique<Probes>(start);
    },
    nullptr,
    {},
    {.row = {.each = 85, .count = [](const effects::Work& w) {
               return w.particles * static_cast<double>(w.scene.probes.size());
             }}}};

}  // namespace rouleau::observe
