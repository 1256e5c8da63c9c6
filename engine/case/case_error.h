#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace rouleau {

/// One thing that is wrong with a case.
struct Fault {
  std::string pointer;  ///< JSON Pointer (RFC 6901) to the value, "" for the whole document
  std::string message;  ///< what was found and what is allowed
};

/// A case that cannot be run, with every fault found in it. `what()` lists them one a line.
class CaseError : public std::runtime_error {
 public:
  explicit CaseError(std::vector<Fault> faults);

  const std::vector<Fault>& faults() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

}  // namespace rouleau
