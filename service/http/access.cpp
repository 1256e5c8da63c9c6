#include "service/http/access.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <stdexcept>

#include <openssl/crypto.h>

#include "service/http/problem.h"
#include "service/http/request_head.h"

namespace rouleau::service {

namespace {

constexpr std::string_view bearer = "Bearer ";
constexpr std::size_t least_token_length = 16;

/// "localhost:8080" -> "localhost", "[::1]:8080" -> "[::1]".
std::string_view without_port(std::string_view host) {
  const auto colon = host.rfind(':');
  const auto bracket = host.rfind(']');
  if (colon == std::string_view::npos || (bracket != std::string_view::npos && colon < bracket)) return host;
  return host.substr(0, colon);
}

}  // namespace

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

void Access::check_token(std::string_view authorization) const {
  if (!needs_token()) return;
  bool known = false;
  if (authorization.size() > bearer.size() &&
      equal_ignoring_case(authorization.substr(0, bearer.size()), bearer)) {
    const std::string_view given = authorization.substr(bearer.size());
    // Every token is compared, each in constant time: how long it takes says nothing about them.
    for (const std::string& token : tokens_) {
      known |= token.size() == given.size() && CRYPTO_memcmp(token.data(), given.data(), given.size()) == 0;
    }
  }
  if (!known) throw Problem(problems::unauthorized, "send a token of this server's token file");
}

std::vector<std::string> read_tokens(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("cannot read the token file " + file.string());
  std::vector<std::string> tokens;
  for (std::string line; std::getline(stream, line);) {
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\t'))
      line.pop_back();
    if (line.empty() || line.front() == '#') continue;
    if (line.size() < least_token_length) {
      throw std::runtime_error("a token in " + file.string() + " has fewer than " +
                               std::to_string(least_token_length) + " characters");
    }
    tokens.push_back(line);
  }
  if (tokens.empty()) throw std::runtime_error("the token file " + file.string() + " holds no token");
  return tokens;
}

bool is_loopback(std::string_view address) {
  return address == "localhost" || address == "::1" || address.starts_with("127.");
}

}  // namespace rouleau::service
