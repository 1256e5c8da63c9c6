#pragma once

#include <memory>
#include <string>

#include "service/http/access.h"
#include "service/http/admission.h"
#include "service/http/rate_limiter.h"
#include "service/http/request_head.h"
#include "service/http/router.h"

namespace rouleau::service {

/// Decides from a request's head whether it is let in: who calls and how often, whether there is such a route
/// and the caller may take it, and whether its body is one that can be read. For one thread alone.
class Gate {
 public:
  Gate(const Router& router, std::shared_ptr<const Access> access, const RateLimit& limit)
      : router_(router), access_(std::move(access)), limiter_(limit) {}

  /// @param address of the peer, which stands for a caller without a name
  Admission admit(const RequestHead& head, const std::string& address);

 private:
  void decide(const RequestHead& head, const std::string& address, Admission& admission);
  void count(const std::string& who, Admission& admission);

  const Router& router_;
  std::shared_ptr<const Access> access_;
  RateLimiter limiter_;
};

}  // namespace rouleau::service
