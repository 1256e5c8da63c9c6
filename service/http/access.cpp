#include "service/http/access.h"

#include <algorithm>
#include <array>

#include <openssl/crypto.h>

#include "service/http/problem.h"
#include "service/http/request_head.h"
#include "storage/sha256.h"

namespace rouleau::service {

namespace {

constexpr std::string_view bearer = "Bearer ";

/// "localhost:8080" -> "localhost", "[::1]:8080" -> "[::1]".
std::string_view without_port(std::string_view host) {
  const auto colon = host.rfind(':');
  const auto bracket = host.rfind(']');
  if (colon == std::string_view::npos || (bracket != std::string_view::npos && colon < bracket)) return host;
  return host.substr(0, colon);
}

}  // namespace

Access::Access(std::vector<Token> tokens)
    : needs_token_(true), tokens_(std::make_shared<const std::vector<Token>>(std::move(tokens))) {}

void Access::replace_tokens(std::vector<Token> tokens) {
  auto replaced = std::make_shared<const std::vector<Token>>(std::move(tokens));
  const std::lock_guard lock(mutex_);
  tokens_.swap(replaced);
}

void Access::check_host(std::string_view host) const {
  if (needs_token()) return;
  static constexpr std::array<std::string_view, 3> names{"localhost", "127.0.0.1", "[::1]"};
  const std::string_view name = without_port(host);
  if (std::none_of(names.begin(), names.end(),
                   [&](std::string_view known) { return equal_ignoring_case(known, name); })) {
    throw Problem(problems::unknown_host, "call this server as localhost, 127.0.0.1 or [::1]");
  }
}

void Access::check_origin(std::string_view origin, std::string_view host) {
  if (origin.empty()) return;
  const auto scheme = origin.find("://");
  if (scheme == std::string_view::npos || !equal_ignoring_case(origin.substr(scheme + 3), host)) {
    throw Problem(problems::cross_origin, "the page that asks does not come from this server");
  }
}

std::optional<Caller> Access::identify(std::string_view authorization) const {
  if (!needs_token()) return Caller{"", Scope::admin};
  if (authorization.size() <= bearer.size() ||
      !equal_ignoring_case(authorization.substr(0, bearer.size()), bearer)) {
    return std::nullopt;
  }
  Tokens tokens;
  {
    const std::lock_guard lock(mutex_);
    tokens = tokens_;
  }
  const std::string given = storage::sha256_hex(authorization.substr(bearer.size()));
  const Token* known = nullptr;
  // Every token is compared, each in constant time: how long it takes says nothing about them.
  for (const Token& token : *tokens) {
    if (CRYPTO_memcmp(token.sha256.data(), given.data(), given.size()) == 0) known = &token;
  }
  if (known == nullptr) return std::nullopt;
  return Caller{known->name, known->scope};
}

bool is_loopback(std::string_view address) {
  return address == "localhost" || address == "::1" || address.starts_with("127.");
}

}  // namespace rouleau::service
