#include "service/api/case_body.h"
#include "service/sweep/sweep_body.h"
#include "service/sweep/sweep_points.h"
#include "tests/fuzz/targets.h"

namespace rouleau::fuzz {

void sweep_body(std::string_view input) {
  // A sweep is all of it read before any of it runs; few points are as telling as many.
  constexpr std::size_t most_points = 32;
  try {
    const auto sweep = service::read_sweep(service::read_body(std::string(input)), most_points, {"priority"});
    must(sweep.points <= most_points);
    const auto points = service::expand(sweep);
    must(points.size() == sweep.points);
    for (const auto& point : points) must(point.choice.size() == sweep.axes.size());
  } catch (const service::Problem& problem) {
    service::dump(service::to_json(problem, ""));
  }
}

}  // namespace rouleau::fuzz
