#include "service/api/waiting.h"

#include <algorithm>

#include "service/api/query.h"
#include "service/http/duration.h"
#include "service/http/problem.h"

namespace rouleau::service {

std::chrono::milliseconds read_wait(const Call& call) {
  constexpr std::chrono::seconds longest{60};
  const auto text = query(call, "wait");
  if (!text) return std::chrono::milliseconds(0);
  const auto wait = parse_duration(*text);
  if (!wait) {
    throw Problem(problems::invalid_request, "a query parameter is not valid",
                  {{"?wait", "must be a duration such as 20s or 500ms"}});
  }
  return std::min<std::chrono::milliseconds>(*wait, longest);
}

bool Waiting::too_many() const {
  constexpr int most = 32;
  return now_ > most;
}

}  // namespace rouleau::service
