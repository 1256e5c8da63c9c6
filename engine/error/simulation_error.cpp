#include "engine/error/simulation_error.h"

#include <iomanip>
#include <sstream>

namespace rouleau {

namespace {

std::string describe(const Breach& breach) {
  const std::string unit = breach.unit == "1" ? "" : " " + breach.unit;
  std::ostringstream text;
  text << std::setprecision(4) << "the run went unstable: " << breach.quantity << " " << breach.value << unit
       << " is beyond its bound of " << breach.bound << unit << " at t = " << breach.time * 1e3
       << " ms (step " << breach.step << ")";
  if (!breach.has_place()) return text.str();
  text << ", at x = " << breach.x * 1e6 << " um, y = " << breach.y * 1e6 << " um";
  if (breach.particle >= 0) text << ", particle " << breach.particle;
  if (breach.cell >= 0) text << (breach.particle >= 0 ? " of" : ",") << " cell " << breach.cell;
  if (!breach.advice.empty()) text << ": " << breach.advice;
  return text.str();
}

}  // namespace

SimulationError::SimulationError(Breach breach)
    : std::runtime_error(describe(breach)), breach_(std::move(breach)) {}

}  // namespace rouleau
