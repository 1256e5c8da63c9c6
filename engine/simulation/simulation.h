#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "engine/bytes/byte_stream.h"
#include "engine/effects/effect.h"
#include "engine/observe/refinement_record.h"
#include "engine/plan/plan.h"
#include "engine/simulation/snapshot.h"
#include "engine/simulation/step_control.h"

namespace rouleau {

/// What an effect or an observer took so far.
struct Usage {
  double seconds = 0;  ///< of wall time
  long rounds = 0;     ///< how often its turn came
  long awake = 0;      ///< in how many of them it ran
};

/// A planned scene and its state, advanced step by step. Knows no output and no clock but the one that
/// measures what each effect costs.
class Simulation {
 public:
  /// Moves, adds or changes particles that were placed for time 0, before anything is built on them.
  using Rearrangement = std::function<void(effects::State&)>;

  /// Places the particles of the plan at time 0.
  /// @param rearrange  for tests: a start that no case describes
  /// @throws CaseError as make_plan, and where a cell has no rest shape
  explicit Simulation(const Case& resolved, const Rearrangement& rearrange = {});

  const Plan& plan() const { return plan_; }
  const effects::State& state() const { return state_; }

  double time() const;  ///< s
  bool finished() const;

  /// Advances by one step through the effects of the plan. A step that breaks a limit is taken again,
  /// smaller.
  /// @throws SimulationError when a value is not finite, a speed is out of bounds or a solver fails, and no
  /// smaller step cures it
  void step();

  const StepCounts& step_counts() const { return step_control_.counts(); }

  /// Whether a node of a membrane is within half a spacing of the inlet plane.
  bool cell_at_inlet() const;

  /// Changes of the spacing so far.
  const std::vector<Refinement>& refinements() const { return refinements_; }

  struct Cost {
    const effects::EffectKind* kind;
    Usage usage;
  };
  /// What each effect took so far, in the order in which they run.
  std::vector<Cost> costs() const;

  /// All that `restore` needs to go on from here as if the run had never stopped.
  void save(ByteWriter& bytes);
  /// @throws CheckpointError if they cannot have been saved by this plan
  void restore(ByteReader& bytes);

 private:
  struct Running {
    const effects::EffectKind* kind;
    std::unique_ptr<effects::Effect> effect;
    Usage usage;
  };

  void make_effects();
  void refine(double spacing);
  /// Goes on from another state of the same scene.
  void remake(effects::State state);
  void run_stage(effects::Stage stage);
  /// Forces, viscosity and pressure where the particles are; returns the change of velocity.
  double solve_flow();
  /// Lets particles shift until they are evenly spread, with no time passing and no flow solved: the first
  /// solution would fail among clumps and holes.
  void spread();
  /// Lets the flow of particles placed anew, at the start or after a refinement, find its way around thrombi
  /// and cells, in no time: steps in which the flow changes and particles shift, but nothing is carried
  /// along. Else the next step would meet a flow through them, far from free of divergence.
  void settle();
  /// One attempt; returns the change of velocity that StepControl judges.
  double attempt();
  /// Keeps it with the particles, for the next step, and returns its size.
  double note_change_of_velocity();

  Plan plan_;
  effects::State state_;
  std::vector<Running> effects_;
  double duration_;
  double planned_step_;  ///< at the start's spacing
  StepControl step_control_;
  Snapshot before_;
  std::vector<Refinement> refinements_;
  std::vector<double> start_u_, start_v_;  ///< of the active particles, as the step found them
};

}  // namespace rouleau
