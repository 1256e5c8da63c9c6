#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/simulation/output.h"
#include "storage/hdf5/growing_array.h"

namespace rouleau::storage {

/// `/probes/NAME`: `x`, `y` [points], `time` [T], `u`, `v`, `p` [T][points], and of a line `flux` [T]. The
/// order of the probes is in the group's attribute `names`.
class ProbeWriter {
 public:
  ProbeWriter(hid_t file, const std::vector<ProbeLine>& probes);

  void add(double time, std::span<const ProbeValues> row);
  /// Rows are gathered and go to the file with the next frame, or when there are many.
  void write_gathered();

 private:
  struct Quantity {
    hdf5::GrowingArray array;
    std::vector<double> gathered;

    void gather(const std::vector<double>& values);
    void write();
  };
  struct Probe {
    std::size_t points;
    Quantity u, v, p;
    std::vector<Quantity> flux;  ///< one of a line, none of a point
    Quantity time;
  };

  std::vector<Probe> probes_;
  int rows_gathered_ = 0;
};

}  // namespace rouleau::storage
