#pragma once

#include <stdexcept>
#include <string>

namespace rouleau {

/// A run that went unstable, and what it was doing: the quantity that left its bounds, where and when.
struct Breach {
  std::string quantity;  ///< "speed", "divergence", "change of a cell's area", ...
  double value = 0;      ///< SI
  double bound = 0;      ///< SI
  std::string unit;
  double time = 0;  ///< s, simulated
  long step = 0;
  double x = 0, y = 0;   ///< m
  long particle = -1;    ///< id, -1 if a whole cell or the whole run is meant
  int cell = -1;         ///< -1 for plasma and the whole run
  bool mendable = true;  ///< by a smaller step; not what grew in many
  std::string advice{};  ///< what would help, if that is known

  /// Whether x and y say anything: what is the whole run's is nowhere.
  bool has_place() const { return particle >= 0 || cell >= 0; }
};

class SimulationError : public std::runtime_error {
 public:
  explicit SimulationError(Breach breach);

  const Breach& breach() const { return breach_; }

 private:
  Breach breach_;
};

}  // namespace rouleau
