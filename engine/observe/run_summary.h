#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/cells/shape_class.h"
#include "engine/observe/refinement_record.h"

namespace rouleau {

enum class Ending {
  completed,           ///< the whole duration
  cell_reached_inlet,  ///< whole until a cell was carried back to the inlet plane
  stopped,             ///< the stop token asked for it
  failed,              ///< whole until a step left its bounds and nothing mended it
};

/// Where and when a cell left the vessel.
struct CellDeparture {
  double time = 0;      ///< s
  int outlet = 0;       ///< of a bifurcation 0 lower, 1 upper
  double x = 0, y = 0;  ///< centroid of the enclosed area, m
};

struct CellSummary {
  double peak_velocity = 0;    ///< of the centroid along x, m/s
  double peak_velocity_x = 0;  ///< where, m
  double peak_tau = 0;
  double least_tau = 0;
  double area_deviation = 0;  ///< the largest |A/A0 - 1|
  double greatest_strain = 0;
  double least_thickness = 0;  ///< m, twice the area over the perimeter
  double least_wall_gap = 0;   ///< m, infinite where there are no walls
  double least_cell_gap = 0;   ///< m, infinite where there is no other cell
  /// Of the simulated time, by the codes of cells::ShapeClass.
  std::array<double, cells::shape_classes> time_as{};
  std::optional<CellDeparture> departure{};
};

template <class Stream>
void visit(Stream& stream, CellDeparture& departure) {
  auto& [time, outlet, x, y] = departure;
  stream(time, outlet, x, y);
}

template <class Stream>
void visit(Stream& stream, CellSummary& cell) {
  auto& [peak_velocity, peak_velocity_x, peak_tau, least_tau, area_deviation, greatest_strain,
         least_thickness, least_wall_gap, least_cell_gap, time_as, departure] = cell;
  stream(peak_velocity, peak_velocity_x, peak_tau, least_tau, area_deviation, greatest_strain,
         least_thickness, least_wall_gap, least_cell_gap, time_as, departure);
}

/// How many steps a limit held where they were (planned, flow, viscous, elastic, error, rejected or end), or
/// had taken again.
struct LimitCount {
  std::string name;
  long steps = 0;
};

/// A quantity that is watched, and the worst of it in all steps that were taken.
struct WatchedQuantity {
  std::string name;
  double worst = 0;
  double bound = 0;
  std::string unit;
};

/// What an effect or an observer took.
struct EffectTime {
  std::string name;
  double seconds = 0;  ///< of wall time
  long rounds = 0;     ///< how often its turn came: once a step, and in steps taken again and in settling
  long awake = 0;      ///< in how many of them it ran
};

/// What an observer found out over the whole run.
struct Finding {
  std::string name;
  double value = 0;
  std::string unit;  ///< SI; "1" where it has none
};

/// How a run ended and what it comes to. SI units.
struct RunSummary {
  Ending ending = Ending::completed;
  std::string reason;         ///< a sentence for a person
  double simulated_time = 0;  ///< s
  long steps = 0;
  long rejected_steps = 0;              ///< taken again smaller, because they broke a limit
  std::vector<LimitCount> rejections;   ///< which: error, or a watched quantity
  std::vector<LimitCount> step_limits;  ///< those that bound
  double least_time_step = 0;           ///< s
  double wall_time = 0;                 ///< s
  double steps_per_second = 0;
  std::vector<CellSummary> cells;
  double volume_in = 0;              ///< net, m2 per unit depth, over the run; 0 in a vessel without openings
  double volume_out = 0;             ///< through all outlets
  double volume_mismatch = 0;        ///< |out - in| over what passed the inlet either way
  double peak_fluid_speed = 0;       ///< m/s
  double poiseuille_deviation = -1;  ///< eq. 22, mean over the last half; -1 where no parabola is expected
  double poiseuille_deviation_worst = -1;  ///< the worst of it there
  std::vector<Refinement> refinements;     ///< changes of the spacing for thin cells
  std::vector<WatchedQuantity> watched;
  std::vector<std::string> warnings;  ///< sentences for a person
  long contact_steps = 0;             ///< in which a membrane was in contact
  long wrong_side = 0;                ///< particles that a membrane let through and that were put back
  double viscosity_iterations = 0;    ///< mean a step
  double pressure_iterations = 0;
  std::vector<Finding> findings;  ///< of observers that the case asks for
  std::vector<EffectTime> effect_times;
};

}  // namespace rouleau
