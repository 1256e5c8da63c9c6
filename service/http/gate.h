#pragma once

#include <memory>
#include <string>

#include "service/http/access.h"
#include "service/http/admission.h"
#include "service/http/request_head.h"
#include "service/http/router.h"

namespace rouleau::service {

/// Decides from a request's head whether it is let in: who calls, whether there is such a route, and whether
/// its body is one that can be read.
class Gate {
 public:
  Gate(const Router& router, std::shared_ptr<const Access> access)
      : router_(router), access_(std::move(access)) {}

  Admission admit(const RequestHead& head) const;

 private:
  void decide(const RequestHead& head, Admission& admission) const;

  const Router& router_;
  std::shared_ptr<const Access> access_;
};

}  // namespace rouleau::service
