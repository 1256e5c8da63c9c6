#pragma once

#include <limits>
#include <string>
#include <vector>

#include "engine/bytes/byte_stream.h"
#include "engine/effects/state.h"
#include "engine/observe/record.h"

namespace rouleau::observe {

/// What the names of cell k's columns begin with.
inline std::string cell_name(std::size_t k) {
  return "cell" + std::to_string(k) + ".";
}

/// The same columns for every cell, cell by cell.
inline std::vector<Column> columns_of_cells(const Case& scene, const std::vector<Column>& of_one) {
  std::vector<Column> columns;
  for (std::size_t k = 0; k < scene.cells.size(); ++k) {
    for (const Column& column : of_one) columns.push_back({cell_name(k) + column.name, column.unit});
  }
  return columns;
}

/// Their values: those that `measure(k)` returns for each cell that is there, NaN for those that have left.
template <class Measure>
void append_of_cells(const effects::State& state, std::size_t of_one, std::vector<double>& values,
                     const Measure& measure) {
  for (std::size_t k = 0; k < state.cells.size(); ++k) {
    if (state.cells[k].departure) {
      values.insert(values.end(), of_one, std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    const std::vector<double> measured = measure(k);
    values.insert(values.end(), measured.begin(), measured.end());
  }
}

/// What an observer keeps for each cell, from a checkpoint, which may be damaged: as many as there were.
template <class Kept>
void restore_of_cells(ByteReader& bytes, std::vector<Kept>& kept) {
  const std::size_t cells = kept.size();
  bytes(kept);
  kept.resize(cells);
}

}  // namespace rouleau::observe
