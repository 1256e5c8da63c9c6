#include "service/http/router.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace rouleau::service {

namespace {

/// @param path begins with a slash
std::vector<std::string> split(std::string_view path) {
  std::vector<std::string> segments;
  path.remove_prefix(1);
  for (;;) {
    const auto slash = path.find('/');
    segments.emplace_back(path.substr(0, slash));
    if (slash == std::string_view::npos) return segments;
    path.remove_prefix(slash + 1);
  }
}

using Part = std::pair<std::string, std::string>;

/// Whether `segment` fits `pattern`; a {name} in it is added to `parts`.
bool fits(std::string_view pattern, std::string_view segment, std::vector<Part>& parts) {
  if (pattern.empty() || pattern.front() != '{') return pattern == segment;
  const auto brace = pattern.find('}');
  const std::string_view suffix = pattern.substr(brace + 1);
  if (segment.size() <= suffix.size() || !segment.ends_with(suffix)) return false;
  const std::string_view value = segment.substr(0, segment.size() - suffix.size());
  if (value.find(':') != std::string_view::npos) return false;
  parts.emplace_back(pattern.substr(1, brace - 1), value);
  return true;
}

std::optional<std::map<std::string, std::string>> fits(const std::vector<std::string>& pattern,
                                                       const std::vector<std::string>& segments) {
  if (pattern.size() != segments.size()) return std::nullopt;
  std::vector<Part> parts;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (!fits(pattern[i], segments[i], parts)) return std::nullopt;
  }
  return std::map<std::string, std::string>(parts.begin(), parts.end());
}

}  // namespace

void Router::add(const std::string& method, std::string_view pattern, Handler handler, Body body,
                 std::optional<Scope> scope) {
  routes_.push_back({method, std::string(pattern), split(pattern), body,
                     scope.value_or(method == "GET" ? Scope::read : Scope::submit), std::move(handler)});
}

Router::Match Router::find(std::string_view method, std::string_view path) const {
  Match match;
  if (!path.starts_with('/')) return match;
  const auto segments = split(path);
  const std::string_view wanted = method == "HEAD" ? "GET" : method;
  for (const Route& route : routes_) {
    auto parts = fits(route.segments, segments);
    if (!parts) continue;
    if (route.method == wanted && match.route == nullptr) {
      match.route = &route;
      match.parts = std::move(*parts);
    }
    match.allowed.push_back(route.method);
    if (route.method == "GET") match.allowed.emplace_back("HEAD");
  }
  std::sort(match.allowed.begin(), match.allowed.end());
  match.allowed.erase(std::unique(match.allowed.begin(), match.allowed.end()), match.allowed.end());
  return match;
}

}  // namespace rouleau::service
