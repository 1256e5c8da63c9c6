#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/observe/record.h"
#include "engine/plan/plan.h"

namespace rouleau {

/// What is known when a run starts.
struct RunHeader : Recorded {
  Case resolved;
  Plan plan;
  std::vector<int> nodes_per_cell;  ///< membrane nodes of each cell
  int capacity = 0;                 ///< no frame holds more particles than this
};

struct Progress {
  double simulated_time = 0;  ///< s
  double duration = 0;        ///< s
  double fraction = 0;
  long steps = 0;
  double steps_per_second = 0;
  double eta_s = 0;  ///< wall time left, s
};

/// All from which a run can go on as if it had never stopped, between two steps. The bytes are the engine's
/// own: `head_of` (engine/simulation/checkpoint.h) says what they belong to.
struct Checkpoint {
  std::vector<std::byte> bytes;
};

/// Where a run delivers what it computes. The run calls these in order, from the thread that runs it;
/// none of them can change the run.
class Output {
 public:
  virtual ~Output() = default;
  virtual void begin(const RunHeader&) {}
  /// One value a column of the header.
  virtual void series_row(std::span<const double>) {}
  /// With each row of the series: its time in s, and one entry a probe of the header. Not called where there
  /// are no probes.
  virtual void probe_row(double, std::span<const ProbeValues>) {}
  virtual void frame(const Frame&) {}
  /// Several times a second at most.
  virtual void progress(const Progress&) {}
  /// All that was delivered until now is before it. Not called unless the run was asked for checkpoints.
  virtual void checkpoint(const Checkpoint&) {}
};

}  // namespace rouleau
