#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rouleau::service {

/// Who may call. Without tokens the server listens on the loopback address alone, and the names under which
/// it may be called are those of the loopback.
class Access {
 public:
  /// Anyone on this machine.
  Access() = default;
  explicit Access(std::vector<std::string> tokens) : tokens_(std::move(tokens)) {}

  bool needs_token() const { return !tokens_.empty(); }

  /// @param host the Host header
  /// @throws Problem 421 for a name through which a foreign page could reach the loopback (DNS rebinding)
  void check_host(std::string_view host) const;

  /// @throws Problem 403 if a page of another site asks for a change
  static void check_origin(std::string_view origin, std::string_view host);

  /// @param authorization the Authorization header
  /// @throws Problem 401
  void check_token(std::string_view authorization) const;

 private:
  std::vector<std::string> tokens_;
};

/// One token a line; blank lines and lines that begin with # are skipped.
/// @throws std::runtime_error if the file cannot be read or holds no token
std::vector<std::string> read_tokens(const std::filesystem::path& file);

/// Whether an address to listen on can be reached from this machine alone.
bool is_loopback(std::string_view address);

}  // namespace rouleau::service
