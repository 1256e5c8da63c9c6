#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rouleau::service {

/// What a caller may do; each includes those before it.
enum class Scope { read, submit, admin };

/// "read,submit": what it comes to. None if a name is unknown or there is no name.
std::optional<Scope> parse_scopes(std::string_view text);
std::string_view to_string(Scope scope);

/// A token as the server knows it: not the token itself.
struct Token {
  std::string name;
  Scope scope = Scope::read;
  std::string sha256;  ///< of the token, in lower-case hex
};

/// Whether a token may have this name: 1 to 64 letters, digits, '-', '_' and '.'.
bool is_token_name(std::string_view name);

/// One token a line: NAME SCOPES SHA256. Blank lines and lines that begin with # are skipped.
/// @throws std::runtime_error naming every line that is wrong
std::vector<Token> parse_tokens(std::string_view text);
/// @throws std::runtime_error also if the file cannot be read or holds no token
std::vector<Token> read_tokens(const std::filesystem::path& file);

/// A token that nobody can guess.
std::string new_token();
std::string token_line(std::string_view name, Scope scope, std::string_view token);

}  // namespace rouleau::service
