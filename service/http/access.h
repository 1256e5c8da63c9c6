#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "service/http/token_file.h"

namespace rouleau::service {

/// Who calls, and what that caller may do.
struct Caller {
  std::string name;  ///< "" where no token is needed
  Scope scope = Scope::read;
};

/// Who may call. Without tokens the server listens on the loopback address alone, and the names under which
/// it may be called are those of the loopback.
class Access {
 public:
  /// Anyone on this machine.
  Access() = default;
  explicit Access(std::vector<Token> tokens);

  bool needs_token() const { return needs_token_; }

  /// From here on these tokens are those that may call. From any thread.
  void replace_tokens(std::vector<Token> tokens);

  /// @param host the Host header
  /// @throws Problem 421 for a name through which a foreign page could reach the loopback (DNS rebinding)
  void check_host(std::string_view host) const;

  /// @throws Problem 403 if a page of another site asks for a change
  static void check_origin(std::string_view origin, std::string_view host);

  /// @param authorization the Authorization header
  /// @return none if it holds no token of this server
  std::optional<Caller> identify(std::string_view authorization) const;

 private:
  using Tokens = std::shared_ptr<const std::vector<Token>>;

  const bool needs_token_ = false;
  mutable std::mutex mutex_;
  Tokens tokens_;
};

/// Whether an address to listen on can be reached from this machine alone.
bool is_loopback(std::string_view address);

}  // namespace rouleau::service
