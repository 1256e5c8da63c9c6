#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/case/case_error.h"

namespace rouleau {

/// More faults than this are counted but not listed, so that a hostile case cannot ask for a huge answer.
inline constexpr std::size_t max_listed_faults = 100;

/// The faults found so far in one case.
class Faults {
 public:
  void add(std::string pointer, std::string message);

  /// Whether nothing was found at `pointer` or below it.
  bool clean(std::string_view pointer) const;

  /// @throws CaseError if there is any fault
  void raise() const;

 private:
  std::vector<Fault> listed_;
  std::size_t unlisted_ = 0;
};

/// `parent` followed by one more key, escaped as RFC 6901 asks.
std::string pointer_to(std::string_view parent, std::string_view key);
std::string pointer_to(std::string_view parent, std::size_t index);

}  // namespace rouleau
