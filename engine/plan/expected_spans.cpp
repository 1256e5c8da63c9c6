#include "engine/plan/expected_spans.h"

#include <algorithm>
#include <cmath>

#include "engine/case/waveform.h"
#include "engine/plan/foreseen_stretch.h"

namespace rouleau {

namespace {

constexpr double copy_of_a_particle = 35;  // ns

// Of a process that writes an archive, from peaks of runs with 1000 to 50000 particles.
constexpr double program = 27e6;
constexpr double a_particle = 2.8e3;
constexpr double published_particle = 1.7e3;

// As StepControl has it: what part of a spacing the fastest fluid moves at most.
constexpr double largest_courant = 0.5;

double rows_of(const std::vector<geometry::Opening>& openings, double spacing) {
  double width = 0;
  for (const geometry::Opening& opening : openings) width += opening.width;
  return width / spacing;
}

effects::Work work_of(const effects::State& start, const StartCounts& counts, const SpacingSpan& span,
                      double finer, double step) {
  const Case& scene = start.scene;
  const double spacing = start.spacing / finer;
  effects::Work work{scene};
  work.particles = counts.particles * finer * finer;
  work.membrane_nodes = counts.membrane_nodes * finer;
  work.wall_nodes = counts.wall_nodes * finer;
  work.inlet_rows = rows_of(start.outline.inlets(), spacing);
  work.outlet_rows = rows_of(start.outline.outlets(), spacing);
  work.along = (start.outline.bounds().x1 - start.outline.bounds().x0) / spacing;
  work.gap = start.outline.narrowest() / spacing;
  work.spacing = span.spacing;
  work.diffusion = step * scene.plasma.kinematic_viscosity / (span.spacing * span.spacing);
  for (const RedCell& cell : scene.cells) {
    const double stiffness = cell.stretch_modulus * step * step /
                             (scene.plasma.density * std::pow(span.spacing, 3) * cell.viscosity_ratio);
    work.stiffness = std::max(work.stiffness, stiffness);
  }
  return work;
}

}  // namespace

std::vector<ExpectedSpan> expected_spans(const effects::State& start, const StartCounts& counts,
                                         double spacing, double step, double fastest) {
  const Numerics& numerics = start.scene.numerics;
  std::vector<ExpectedSpan> spans;
  for (const SpacingSpan& span : foresee_spacings(start, spacing)) {
    const double finer = spacing / span.spacing;
    double taken = numerics.time_step ? step : step / finer;
    if (numerics.preset != Preset::paper) taken = std::min(taken, largest_courant * span.spacing / fastest);
    spans.push_back({Rounds::of(start, taken, span.duration), work_of(start, counts, span, finer, taken),
                     taken, span.spacing});
    if (spans.size() > 1) spans.back().rounds.starts = 0;
  }
  return spans;
}

double expected_time_of_steps(const ExpectedSpan& span) {
  return copy_of_a_particle * span.work.particles * (span.rounds.steps + span.rounds.settling);
}

double expected_memory(const std::vector<ExpectedSpan>& spans) {
  double most = 0;
  for (const ExpectedSpan& span : spans) most = std::max(most, span.work.particles);
  const bool published = spans.front().work.scene.numerics.preset == Preset::paper;
  return program + (published ? published_particle : a_particle) * most;
}

}  // namespace rouleau
