#pragma once

#include "engine/operators/sampler.h"
#include "engine/simulation/simulation.h"
#include "tests/validation/scenes.h"

namespace rouleau::validation {

/// A scene under way, looked at in the engine's own units.
class Flow {
 public:
  explicit Flow(const Case& scene) : simulation_(scene) {}

  /// Steps until this time in s is reached; a step may go beyond it, `time` says by how much.
  void advance_to(double time);
  void finish() { advance_to(state().scene.duration); }

  double time() const { return simulation_.time(); }  ///< s
  bool finished() const { return simulation_.finished(); }
  const effects::State& state() const { return simulation_.state(); }
  const StepCounts& step_counts() const { return simulation_.step_counts(); }
  void step() { simulation_.step(); }

  /// Of velocity and pressure as they are now; valid until the next step.
  operators::Sampler sampler() const;

  /// The greatest divergence of the velocity, times the spacing.
  double divergence() const;

  /// What the run came to, without errors.
  Measurement measurement() const;

 private:
  Simulation simulation_;
};

}  // namespace rouleau::validation
