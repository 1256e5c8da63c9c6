#include "service/api/idempotency.h"

#include <algorithm>

#include "service/http/problem.h"
#include "storage/sha256.h"

namespace rouleau::service {

namespace {

constexpr std::size_t longest_key = 255;

bool is_printable(char c) {
  return c > ' ' && c <= '~';
}

}  // namespace

KeysInFlight::Hold::Hold(KeysInFlight& keys, const std::optional<storage::IdempotencyKey>& key)
    : keys_(keys) {
  if (!key) return;
  key_ = {key->caller, key->key};
  const std::lock_guard lock(keys_.mutex_);
  holds_ = keys_.keys_.insert(key_).second;
  if (!holds_) {
    throw Problem(problems::idempotency_in_progress, "a request with this key is being worked on");
  }
}

KeysInFlight::Hold::~Hold() {
  if (!holds_) return;
  const std::lock_guard lock(keys_.mutex_);
  keys_.keys_.erase(key_);
}

std::optional<storage::IdempotencyKey> idempotency_key(const Call& call) {
  constexpr const char* name = "Idempotency-Key";
  if (!call.request.has_header(name)) return std::nullopt;
  const std::string key = call.request.get_header_value(name);
  if (key.empty() || key.size() > longest_key || !std::all_of(key.begin(), key.end(), is_printable) ||
      call.request.get_header_value_count(name) > 1) {
    throw Problem(problems::invalid_request, "the Idempotency-Key is not valid",
                  {{"Idempotency-Key", "must be one key of 1 to " + std::to_string(longest_key) +
                                           " printable ASCII characters without blanks"}});
  }
  return storage::IdempotencyKey{call.caller, key,
                                 storage::sha256_hex(call.request.path + '\n' + call.request.body)};
}

}  // namespace rouleau::service
