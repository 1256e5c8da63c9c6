#pragma once

#include "engine/bytes/byte_stream.h"
#include "engine/effects/state.h"
#include "engine/observe/refinement_record.h"
#include "engine/simulation/simulation.h"
#include "engine/simulation/step_control.h"

/// What lasts from step to step, listed for checkpoints. Structured bindings name every member, so that one
/// that is added does not compile before it is listed here.

namespace rouleau {

template <class Stream>
void visit(Stream& stream, Rejection& rejection) {
  auto& [cause, steps] = rejection;
  stream(cause, steps);
}

template <class Stream>
void visit(Stream& stream, StepCounts& counts) {
  auto& [bound, rejected, rejections, least, most] = counts;
  stream(bound, rejected, rejections, least, most);
}

template <class Stream>
void visit(Stream& stream, Usage& usage) {
  auto& [seconds, rounds, awake] = usage;
  stream(seconds, rounds, awake);
}

template <class Stream>
void visit(Stream& stream, Refinement& refinement) {
  auto& [time, cell, spacing] = refinement;
  stream(time, cell, spacing);
}

namespace cells {

template <class Stream>
void visit(Stream& stream, Material& material) {
  auto& [stretch_modulus, bend_modulus, rest_length, crush_stiffening, rest_lengths] = material;
  stream(stretch_modulus, bend_modulus, rest_length, crush_stiffening, rest_lengths);
}

template <class Stream>
void visit(Stream& stream, HeldLinks& held) {
  auto& [length, tension] = held;
  stream(length, tension);
}

}  // namespace cells

namespace effects {

template <class Stream>
void visit(Stream& stream, Departure& departure) {
  auto& [time, outlet, x, y] = departure;
  stream(time, outlet, x, y);
}

template <class Stream>
void visit(Stream& stream, CellState& cell) {
  auto& [first_node, nodes, material, start_nodes, first_id, start_area, start_inertia_nodes,
         start_inertia_area, start_perimeter, start_phase, circle_area, circle_particles, area_rate, presence,
         departure, held] = cell;
  stream(first_node, nodes, material, start_nodes, first_id, start_area, start_inertia_nodes,
         start_inertia_area, start_perimeter, start_phase, circle_area, circle_particles, area_rate, presence,
         departure, held);
}

template <class Stream>
void visit(Stream& stream, Lane& lane) {
  auto& [y, velocity, speed, head] = lane;
  stream(y, velocity, speed, head);
}

template <class Stream>
void visit(Stream& stream, CellExtremes& extremes) {
  auto& [area, area_drift, least_perimeter, most_perimeter, least_thickness, thinnest_time] = extremes;
  stream(area, area_drift, least_perimeter, most_perimeter, least_thickness, thinnest_time);
}

template <class Stream>
void visit(Stream& stream, Counters& counters) {
  auto& [wrong_side, contact_steps, emitted, absorbed, viscosity_iterations, pressure_iterations, peak_speed,
         worst_divergence, cells] = counters;
  stream(wrong_side, contact_steps, emitted, absorbed, viscosity_iterations, pressure_iterations, peak_speed,
         worst_divergence, cells);
}

/// The rest of a state follows from the scene, or is found anew in every step.
template <class Stream>
void visit(Stream& stream, State& state) {
  stream(state.time, state.step, state.dt, state.last_dt, state.speed, state.particles, state.cells,
         state.lanes, state.counters);
}

}  // namespace effects

/// Whether a spacing that was read can be one that a state was refined to.
/// @throws CheckpointError
void check_spacing(double spacing, const effects::State& state);

/// Whether a state that was read can be one of its scene: whatever the bytes were, a run goes on from it
/// without touching memory that is not its own.
/// @throws CheckpointError
void check_lasting(const effects::State& state, std::size_t lanes);

}  // namespace rouleau
