#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/plan/plan.h"

namespace rouleau {

/// A column of the time series: its fixed name (docs/api.md) and its SI unit ("1" where it has none).
struct Column {
  std::string name;
  std::string unit;
};

enum class ParticleKind : std::uint8_t { plasma = 0, inside = 1, membrane = 2 };

/// The moving particles at one instant, in SI units. Arrays have one entry a particle; the membrane nodes
/// come first, cell by cell and counter-clockwise within a cell, so a cell's outline is a run of them.
struct Frame {
  double time = 0;  ///< s
  long step = 0;
  std::vector<std::int64_t> id;  ///< one number for a particle's whole life
  std::vector<ParticleKind> kind;
  std::vector<std::int32_t> cell;  ///< cell it belongs to, -1 for plasma
  std::vector<float> x, y;         ///< m
  // Each of these is empty unless `output.fields` names it.
  std::vector<float> u, v;               ///< m/s
  std::vector<float> p;                  ///< Pa
  std::vector<float> wall_shear_stress;  ///< [wall nodes of the header] Pa
};

/// Where the stress on the walls is sampled: wall by wall, along each in the direction of +x, and of +y where
/// a wall stands upright. In a vessel with open ends that is from the inlet to the outlets.
struct WallNodes {
  std::vector<double> x, y;        ///< [nodes] m
  std::vector<double> nx, ny;      ///< unit normal into the fluid
  std::vector<double> arc_length;  ///< m, from the first node of the same wall
  std::vector<std::int32_t> wall;  ///< number of the wall
};

/// Where a probe samples.
struct ProbeLine {
  std::string name;
  std::vector<double> x, y;  ///< [points] m
  bool has_flux = false;     ///< it is a line, not a point
};

/// What a probe sees at one instant, in SI units. A point outside the fluid has NaN for each.
struct ProbeValues {
  std::vector<double> u, v;  ///< [points] m/s
  std::vector<double> p;     ///< [points] Pa
  /// Through the line, m2/s per unit depth; positive from its left to its right as one goes along it: a line
  /// from the lower wall to the upper one counts flow along +x as positive.
  double flux = 0;
};

/// Whether frames of this case carry a field.
bool carries(const Case& scene, Field field);

/// What is known when a run starts.
struct RunHeader {
  Case resolved;
  Plan plan;
  std::vector<Column> columns;  ///< of the series
  std::vector<ProbeLine> probes;
  WallNodes walls;                  ///< none unless frames carry the stress on them
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
