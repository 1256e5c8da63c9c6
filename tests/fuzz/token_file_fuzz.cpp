#include <stdexcept>

#include "service/http/token_file.h"
#include "tests/fuzz/targets.h"

namespace rouleau::fuzz {

void token_file(std::string_view input) {
  try {
    for (const auto& token : service::parse_tokens(input)) {
      must(service::is_token_name(token.name) && token.sha256.size() == 64);
    }
  } catch (const std::runtime_error&) {
    return;
  }
}

}  // namespace rouleau::fuzz
