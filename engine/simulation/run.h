#pragma once

#include <array>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "engine/cells/shape_class.h"
#include "engine/observe/output.h"
#include "engine/simulation/refinement_record.h"

namespace rouleau {

/// The engine's version; the same version and the same case give the same bits.
const char* engine_version();

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

struct EffectTime {
  std::string name;
  double seconds = 0;
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
  std::vector<EffectTime> effect_times;
};

/// How a run can be interrupted and taken up again.
struct Continuation {
  /// What to go on from, if not from the start. `output.begin` is called all the same; rows and frames are
  /// those that come after the checkpoint.
  const Checkpoint* from = nullptr;
  /// s of wall time between checkpoints, and one more when the stop token ends the run; 0: none
  double interval = 0;
};

/// Runs a case from start to end, delivering to `output`. However often it is interrupted and taken up again,
/// what it delivers is the same to the last bit, but for the wall time spent.
/// @throws CaseError if the case cannot be planned or a cell has no rest shape, RunFailure (a
/// SimulationError) if the run goes unstable, CheckpointError if it cannot go on from the checkpoint given
RunSummary run_case(const Case& resolved, Output& output, const std::stop_token& stop = {},
                    const Continuation& continuation = {});

nlohmann::json to_json(const RunSummary& summary);

}  // namespace rouleau
