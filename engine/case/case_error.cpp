#include "engine/case/case_error.h"

#include <utility>

namespace rouleau {
namespace {

std::string one_a_line(const std::vector<Fault>& faults) {
  std::string text;
  for (const Fault& fault : faults) {
    if (!text.empty()) text += '\n';
    text += fault.pointer.empty() ? "the whole case" : fault.pointer;
    text += ": " + fault.message;
  }
  return text;
}

}  // namespace

CaseError::CaseError(std::vector<Fault> faults)
    : std::runtime_error(one_a_line(faults)), faults_(std::move(faults)) {}

}  // namespace rouleau
