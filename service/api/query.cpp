#include "service/api/query.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "service/http/problem.h"

namespace rouleau::service {

namespace {

bool contains(std::initializer_list<std::string_view> names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Problem bad_parameter(const std::string& name, const std::string& message) {
  return {problems::invalid_request, "a query parameter is not valid", {{"?" + name, message}}};
}

template <class Number>
std::optional<Number> parse(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

void check_query(const Call& call, std::initializer_list<std::string_view> known,
                 std::initializer_list<std::string_view> repeatable) {
  std::vector<Fault> faults;
  std::string last;
  for (const auto& [name, value] : call.request.params) {
    if (!contains(known, name) && !contains(repeatable, name)) {
      faults.push_back({"?" + name, "unknown query parameter"});
    } else if (name == last && !contains(repeatable, name)) {
      faults.push_back({"?" + name, "given more than once"});
    }
    last = name;
  }
  if (!faults.empty()) throw Problem(problems::invalid_request, "the query is not valid", std::move(faults));
}

std::optional<std::string> query(const Call& call, const std::string& name) {
  std::string value = call.request.get_param_value(name);
  if (value.empty()) return std::nullopt;
  return value;
}

std::optional<int> query_integer(const Call& call, const std::string& name, int least, int most) {
  const auto text = query(call, name);
  if (!text) return std::nullopt;
  const auto value = parse<int>(*text);
  if (!value || *value < least || *value > most) {
    throw bad_parameter(
        name, "must be a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  }
  return value;
}

std::optional<double> query_number(const Call& call, const std::string& name) {
  const auto text = query(call, name);
  if (!text) return std::nullopt;
  const auto value = parse<double>(*text);
  if (!value || !std::isfinite(*value)) throw bad_parameter(name, "must be a number");
  return value;
}

std::vector<std::string> split_list(std::string_view text) {
  std::vector<std::string> words;
  while (!text.empty()) {
    const auto comma = text.find(',');
    if (comma != 0) words.emplace_back(text.substr(0, comma));
    if (comma == std::string_view::npos) break;
    text.remove_prefix(comma + 1);
  }
  return words;
}

}  // namespace rouleau::service
