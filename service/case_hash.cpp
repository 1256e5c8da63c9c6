#include "service/case_hash.h"

#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "engine/simulation/run.h"
#include "storage/sha256.h"

namespace rouleau::service {

std::string case_hash(const Case& resolved) {
  nlohmann::json unnamed = to_json(resolved);
  unnamed.erase("name");
  return storage::sha256_hex(std::string(engine_version()) + '\n' + unnamed.dump());
}

}  // namespace rouleau::service
