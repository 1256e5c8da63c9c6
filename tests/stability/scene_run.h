#pragma once

#include <string>
#include <vector>

#include "engine/simulation/simulation.h"
#include "tests/stability/watcher.h"

namespace rouleau::stability {

/// What a run came to.
struct Report {
  std::string outcome;  ///< completed, refused (before anything is computed) or stopped
  std::string message;  ///< why, if it was refused or stopped: with what, where and when
  WorstOf worst;
  double simulated_time = 0;  ///< s
  long steps = 0;
  long rejected = 0;
  long put_back = 0;  ///< particles that a membrane let through in a step and that were put back in it
  int particles = 0;  ///< at the end, solved for

  /// What went beyond its bound; "outcome" stands for a run that did not complete.
  std::vector<std::string> misses() const;
};

/// Where cells were, at every step.
struct Path {
  std::vector<double> times;                     ///< s
  std::vector<std::vector<Centroid>> centroids;  ///< [cells][times]; shorter once the cell has left
};

/// A case run to its end under the eyes of a Watcher.
class SceneRun {
 public:
  /// The case passes the checks that a user's passes.
  explicit SceneRun(const Case& scene, const Simulation::Rearrangement& rearrange = {});

  Report report;
  Path path;
  std::vector<double> kinetic_energy;  ///< of the plasma, in own units, at the start and after every step
  double potential_energy = 0;         ///< what it would take to lift all of it by the vessel's height

 private:
  void note(const Simulation& simulation);
  void finish(Simulation& simulation, Watcher& watcher);
};

/// The greatest distance between where two runs have a cell at the same time, over the way that it goes in
/// the first one.
double deviation(const Path& one, const Path& other, std::size_t cell);

}  // namespace rouleau::stability
