#include "engine/case/faults.h"

#include <algorithm>
#include <utility>

namespace rouleau {

void Faults::add(std::string pointer, std::string message) {
  if (listed_.size() < max_listed_faults) {
    listed_.push_back({std::move(pointer), std::move(message)});
  } else {
    ++unlisted_;
  }
}

bool Faults::clean(std::string_view pointer) const {
  if (unlisted_ > 0) return false;
  return std::none_of(listed_.begin(), listed_.end(), [pointer](const Fault& fault) {
    const std::string_view found = fault.pointer;
    return found.starts_with(pointer) && (found.size() == pointer.size() || found[pointer.size()] == '/');
  });
}

void Faults::raise() const {
  if (listed_.empty()) return;
  std::vector<Fault> faults = listed_;
  if (unlisted_ > 0) faults.push_back({"", "and " + std::to_string(unlisted_) + " more faults"});
  throw CaseError(std::move(faults));
}

std::string pointer_to(std::string_view parent, std::string_view key) {
  std::string pointer(parent);
  pointer += '/';
  for (const char c : key) {
    if (c == '~') {
      pointer += "~0";
    } else if (c == '/') {
      pointer += "~1";
    } else {
      pointer += c;
    }
  }
  return pointer;
}

std::string pointer_to(std::string_view parent, std::size_t index) {
  return std::string(parent) + '/' + std::to_string(index);
}

}  // namespace rouleau
