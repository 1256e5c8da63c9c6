#pragma once

#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "service/http/router.h"
#include "storage/job.h"

namespace rouleau::service {

/// The keys of requests that are being worked on.
class KeysInFlight {
 public:
  /// Holds a key as long as it lives.
  class Hold {
   public:
    /// @throws Problem 409 idempotency-in-progress
    Hold(KeysInFlight& keys, const std::optional<storage::IdempotencyKey>& key);
    ~Hold();
    Hold(const Hold&) = delete;
    Hold& operator=(const Hold&) = delete;

   private:
    KeysInFlight& keys_;
    std::pair<std::string, std::string> key_;
    bool holds_ = false;
  };

 private:
  std::mutex mutex_;
  std::set<std::pair<std::string, std::string>> keys_;
};

/// The Idempotency-Key of a request together with what identifies the whole request, if it has one.
/// @throws Problem 400
std::optional<storage::IdempotencyKey> idempotency_key(const Call& call);

}  // namespace rouleau::service
