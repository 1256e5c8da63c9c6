#include "engine/simulation/calibration.h"

#include <algorithm>
#include <ctime>
#include <vector>

#include "engine/case/case_json.h"
#include "engine/simulation/simulation.h"

namespace rouleau {

namespace {

// Until memory is there and the solvers start from increments of steps before.
constexpr int warm_up_steps = 5;
constexpr int steps_a_batch = 8;
constexpr int least_batches = 3, most_batches = 25;
constexpr double enough = 0.5;  // s of processor time
// Of what its plan says the scene takes, on the machine to which costs refer: it is small and stays in the
// cache. Runs of the calibration scenes took this much longer than a measurement beside them said.
constexpr double of_its_plan = 0.91;

constexpr const char* scene = R"({
  "version": 1,
  "vessel": {"length": 4e-5, "diameter": 1e-5},
  "duration": 5e-3,
  "output": {"series_interval": 0, "frame_interval": 0}
})";

/// Of this thread, s.
double processor_time() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

Machine measure_machine() {
  Simulation simulation(read_case(scene));
  for (int k = 0; k < warm_up_steps; ++k) simulation.step();
  const double start = processor_time();
  std::vector<double> batches;
  while (batches.size() < most_batches &&
         (batches.size() < least_batches || processor_time() - start < enough)) {
    const double before = processor_time();
    for (int k = 0; k < steps_a_batch; ++k) simulation.step();
    batches.push_back((processor_time() - before) / steps_a_batch);
  }
  const auto middle = batches.begin() + static_cast<std::ptrdiff_t>(batches.size() / 2);
  std::nth_element(batches.begin(), middle, batches.end());
  return {*middle / (of_its_plan * simulation.plan().step_time), true};
}

}  // namespace rouleau
