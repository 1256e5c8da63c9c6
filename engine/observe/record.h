#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/case/case.h"

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
  std::vector<float> u, v;                          ///< m/s
  std::vector<float> p;                             ///< Pa
  std::vector<float> wall_shear_stress;             ///< [wall nodes of the header] Pa
  std::vector<std::vector<float>> membrane_fields;  ///< [fields of the header][membrane nodes]
};

/// A field that frames carry on the membrane nodes: its name and its SI unit.
struct MembraneField {
  std::string name;
  std::string unit;
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

/// What a run records, known when it starts.
struct Recorded {
  std::vector<Column> columns;  ///< of the series
  std::vector<ProbeLine> probes;
  WallNodes walls;                             ///< none unless frames carry the stress on them
  std::vector<MembraneField> membrane_fields;  ///< none unless the case asks for them
};

/// A row of the series with what the probes see at that time.
struct Row {
  std::vector<double> values;       ///< one a column, SI
  std::vector<ProbeValues> probes;  ///< one a probe
};

/// Whether frames of this case carry a field.
bool carries(const Case& scene, Field field);

}  // namespace rouleau
