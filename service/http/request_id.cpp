#include "service/http/request_id.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <random>

namespace rouleau::service {

std::string new_request_id() {
  thread_local std::mt19937_64 random{std::random_device{}()};
  std::array<char, 17> text;
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(random()));
  return text.data();
}

}  // namespace rouleau::service
