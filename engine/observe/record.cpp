#include "engine/observe/record.h"

#include <algorithm>

namespace rouleau {

bool carries(const Case& scene, Field field) {
  const auto& fields = scene.output.fields;
  return std::find(fields.begin(), fields.end(), field) != fields.end();
}

}  // namespace rouleau
