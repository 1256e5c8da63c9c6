#include "service/queue/progress_json.h"

#include <nlohmann/json.hpp>

namespace rouleau::service {

nlohmann::json to_json(const Progress& progress) {
  return {{"simulated_time", progress.simulated_time},
          {"duration", progress.duration},
          {"fraction", progress.fraction},
          {"steps", progress.steps},
          {"steps_per_second", progress.steps_per_second},
          {"eta_s", progress.eta_s}};
}

}  // namespace rouleau::service
