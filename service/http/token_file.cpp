#include "service/http/token_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include <openssl/rand.h>

#include "storage/sha256.h"

namespace rouleau::service {

namespace {

constexpr std::size_t longest_name = 64;
constexpr std::size_t sha256_digits = 64;
constexpr std::size_t token_bytes = 32;
// By which those who look for lost secrets know one.
constexpr std::string_view token_prefix = "rouleau_";

constexpr std::array<std::string_view, 3> scope_names{"read", "submit", "admin"};

bool is_sha256(std::string_view text) {
  return text.size() == sha256_digits && std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
         });
}

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

/// What is wrong with a line; "" if nothing is.
std::string fault_of(const std::vector<std::string>& words) {
  if (words.size() == 1) {
    return "a token by itself is no longer taken; make one with `rouleau token NAME --scopes read,submit` "
           "and put the line that it prints here";
  }
  if (words.size() != 3) return "must be NAME SCOPES SHA256";
  if (!is_token_name(words[0])) return "a name has 1 to 64 letters, digits, '-', '_' and '.'";
  if (!parse_scopes(words[1])) return "scopes are read, submit and admin, with commas";
  if (!is_sha256(words[2])) return "the third word must be a SHA-256 in lower-case hex";
  return {};
}

}  // namespace

std::optional<Scope> parse_scopes(std::string_view text) {
  std::optional<Scope> scope;
  for (;;) {
    const auto comma = text.find(',');
    const auto found = std::find(scope_names.begin(), scope_names.end(), text.substr(0, comma));
    if (found == scope_names.end()) return std::nullopt;
    scope = std::max(scope.value_or(Scope::read), static_cast<Scope>(found - scope_names.begin()));
    if (comma == std::string_view::npos) return scope;
    text.remove_prefix(comma + 1);
  }
}

std::string_view to_string(Scope scope) {
  return scope_names[static_cast<std::size_t>(scope)];
}

bool is_token_name(std::string_view name) {
  return !name.empty() && name.size() <= longest_name && std::all_of(name.begin(), name.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == '.';
  });
}

std::vector<Token> parse_tokens(std::string_view text) {
  std::vector<Token> tokens;
  std::string faults;
  std::istringstream lines{std::string(text)};
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const auto words = words_of(line);
    if (words.empty() || words[0].starts_with('#')) continue;
    if (const std::string fault = fault_of(words); !fault.empty()) {
      faults += "\n  line " + std::to_string(number) + ": " + fault;
    } else {
      tokens.push_back({words[0], *parse_scopes(words[1]), words[2]});
    }
  }
  if (!faults.empty()) throw std::runtime_error("these lines are wrong:" + faults);
  return tokens;
}

std::vector<Token> read_tokens(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("cannot read the token file " + file.string());
  try {
    auto tokens = parse_tokens(std::string(std::istreambuf_iterator<char>(stream), {}));
    if (tokens.empty()) throw std::runtime_error("it holds no token");
    return tokens;
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("the token file " + file.string() + ": " + error.what());
  }
}

std::string new_token() {
  std::array<unsigned char, token_bytes> bytes;
  if (RAND_bytes(bytes.data(), static_cast<int>(bytes.size())) != 1) {
    throw std::runtime_error("the system gives no random bytes");
  }
  std::string token(token_prefix);
  for (const unsigned char byte : bytes) {
    token += "0123456789abcdef"[byte >> 4];
    token += "0123456789abcdef"[byte & 15];
  }
  return token;
}

std::string token_line(std::string_view name, Scope scope, std::string_view token) {
  return std::string(name) + ' ' + std::string(to_string(scope)) + ' ' + storage::sha256_hex(token);
}

}  // namespace rouleau::service
