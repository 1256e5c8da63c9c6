#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/case/case.h"
#include "engine/case/scales.h"
#include "engine/cells/inextensible.h"
#include "engine/cells/material.h"
#include "engine/cells/ring.h"
#include "engine/cells/stiffness.h"
#include "engine/effects/density_projection.h"
#include "engine/geometry/outline.h"
#include "engine/operators/cross_section.h"
#include "engine/operators/least_squares.h"
#include "engine/operators/scraper_flow.h"
#include "engine/particles/neighbour_list.h"
#include "engine/particles/particle_set.h"

namespace rouleau::effects {

/// Where and when a cell left the vessel.
struct Departure {
  double time = 0;
  int outlet = 0;
  double x = 0, y = 0;  ///< of the centroid of the area it enclosed
};

/// A red cell in the simulation: a run of membrane nodes, which are particles like any other.
struct CellState {
  int first_node = 0;  ///< index of its first node among the particles
  int nodes = 0;       ///< none once it has left
  cells::Material material;
  int start_nodes = 0;             ///< how many it had at first
  std::int64_t first_id = 0;       ///< of the first of them; the others follow
  double start_area = 0;           ///< enclosed area that it keeps; while it deflates, the present one
  double start_inertia_nodes = 0;  ///< what tau refers to (eq. 23)
  double start_inertia_area = 0;
  double start_perimeter = 0;
  double start_phase = 0;                ///< of tank-treading, degrees
  double circle_area = 0;                ///< of a cell that deflates: its area at the start
  int circle_particles = 0;              ///< and how many particles it enclosed then
  double area_rate = 0;                  ///< divergence inside by which its area changes as it is to
  double presence = 1;                   ///< by how much its membrane is felt; sinks to 0 before an outlet
  std::optional<Departure> departure{};  ///< once it has left
  cells::HeldLinks held{};               ///< of an inextensible membrane
};

/// A force that is taken at the end of the step, so that a stiff membrane does not shrink the step.
class ImplicitForce {
 public:
  virtual ~ImplicitForce() = default;
  /// Adds to `acceleration` what the velocities `velocity`, held for `time`, make of it; both interleaved
  /// (u0, v0, u1, v1, ...), over the active particles and, for the velocities, those of walls and buffers.
  virtual void add_response(const double* velocity, double time, double* acceleration) const = 0;
  virtual void add_response(const float* velocity, double time, float* acceleration) const = 0;
};

/// Forces on the membrane nodes, per unit depth, and how they answer to a displacement.
struct MembraneLoad {
  std::vector<double> fx, fy;  ///< [membrane nodes]
  std::vector<cells::Stiffness> stiffness;
};

/// A row of an inlet's buffer: particles one spacing apart that move along x as one.
struct Lane {
  double y = 0;
  double velocity = 0;  ///< where the waveform's factor is 1
  double speed = 0;     ///< its present velocity
  double head = 0;      ///< x of the particle nearest to the inlet plane
};

/// What a cell went through, for the summary.
struct CellExtremes {
  double area = 1;                                 ///< after the last step, over that at the start
  double area_drift = 0;                           ///< |A / A0 - 1|
  double least_perimeter = 1, most_perimeter = 1;  ///< over that at the start
  double least_thickness = 1e300;                  ///< twice the area over the perimeter, in spacings
  double thinnest_time = 0;
};

/// What happened so far, for the summary.
struct Counters {
  long wrong_side = 0;
  long contact_steps = 0;  ///< in which a membrane was in contact
  long emitted = 0, absorbed = 0;
  long viscosity_iterations = 0, pressure_iterations = 0;
  double peak_speed = 0;
  double worst_divergence = 0;  ///< times the spacing, over the fastest flow
  std::vector<CellExtremes> cells;
};

/// Everything that effects share: the particles, the operators on them, and what one effect of a step
/// leaves for the next. Lengths in vessel diameters, velocities in mean inflow velocities, density 1.
struct State {
  State(const Case& given, const Scales& units, double at_spacing)
      : State(given, units, at_spacing, at_spacing) {}
  State(const Case& given, const Scales& units, double at_spacing, double at_start_spacing);

  Case scene;
  Scales scales;
  geometry::Outline outline;
  double spacing;        ///< d0
  double start_spacing;  ///< d0 before any refinement
  double viscosity;      ///< kinematic
  double radius;         ///< of the least-squares fits
  double near_radius;    ///< of the pressure equation and of shifting: 2.1 d0; the kernel's in preset paper

  double time = 0;
  long step = 0;
  double dt = 0;
  double last_dt = 0;        ///< of the step before; 0: there was none
  double inflow_factor = 1;  ///< of the inlet's mean velocity, at the end of the step
  double speed = 0;          ///< the fastest particle's, at the end of the last step

  particles::ParticleSet particles;
  particles::NeighbourList neighbours;
  operators::LeastSquares operators;
  DensityProjection projection;  ///< of the published scheme
  std::vector<CellState> cells;
  std::vector<Lane> lanes;
  MembraneLoad load;
  std::optional<operators::ScraperFlow> corner_flow;  ///< that the fits leave out; none: the fits are of all

  // Over the active particles, valid within a step.
  std::vector<double> ax, ay;  ///< acceleration by forces of this step
  std::vector<const ImplicitForce*> implicit_forces;
  std::vector<double> viscosity_factor;          ///< over the plasma's, of all that have a velocity; empty: 1
  std::vector<double> source;                    ///< the divergence that is wanted there
  std::vector<double> divergence;                ///< that the published scheme leaves
  std::vector<double> pressure_gx, pressure_gy;  ///< gradient of p at the end of the step
  std::vector<double> shift_x, shift_y;          ///< displacement beside the flow's
  // Over all particles.
  std::vector<double> next_x, next_y;  ///< positions carried along by the flow alone

  double wanted_spacing = 0;  ///< a finer one that the present step called for; 0: none
  int thinnest_cell = -1;     ///< the cell that did

  Counters counters;

  /// Its nodes are contiguous in space: of a periodic vessel some may lie beyond the ends.
  cells::Ring ring(const CellState& cell) const;
  /// The whole periods in a difference of positions: without them it is that of the nearest images.
  double periods_x(double dx) const { return whole_periods(dx, outline.period_x()); }
  double periods_y(double dy) const { return whole_periods(dy, outline.period_y()); }
  /// Particles side by side over a width, those on the walls not counted.
  int rows_across(double width) const;
  /// Where row k of the particles across the vessel (1 to rows) is, and by how much it is displaced along
  /// x against its neighbours (-0.5 to 0.5 spacings, by the golden ratio), so that no column crosses the
  /// inlet or the outlet at once. None with cells in the published scheme, which takes the number
  /// density of displaced rows for a source: it drives a cell off the axis.
  int rows() const;
  double row_y(int k) const;
  double row_offset(int k) const;
  /// The plane across the vessel at x, to measure the flow through it.
  operators::SamplingPlane plane_at(double x) const;
  /// The developed flow of mean 1, at a fraction of the way across.
  static double parabola(double fraction) { return 6 * fraction * (1 - fraction); }

 private:
  static double whole_periods(double difference, double period) {
    return period > 0 ? period * std::round(difference / period) : 0;
  }
};

}  // namespace rouleau::effects
