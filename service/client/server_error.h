#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/case/case_error.h"

namespace rouleau::service {

/// A server answered with a problem.
class ServerError : public std::runtime_error {
 public:
  ServerError(int status, const std::string& message, std::vector<Fault> faults)
      : std::runtime_error(message), status_(status), faults_(std::move(faults)) {}

  int status() const { return status_; }
  const std::vector<Fault>& faults() const { return faults_; }
  bool is_bad_input() const { return status_ == 400 || status_ == 404 || status_ == 422; }

 private:
  int status_;
  std::vector<Fault> faults_;
};

}  // namespace rouleau::service
