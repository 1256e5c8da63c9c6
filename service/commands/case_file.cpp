#include "service/commands/case_file.h"

#include <fstream>
#include <iterator>

#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "service/commands/command.h"

namespace rouleau::service {

std::string read_case_file(const std::filesystem::path& file) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  if (error) throw CommandError(exit_bad_input, "cannot read " + file.string() + ": " + error.message());
  if (size > max_case_bytes) {
    throw CommandError(exit_bad_input, file.string() + " has " + std::to_string(size) +
                                           " bytes; a case has at most " + std::to_string(max_case_bytes));
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw CommandError(exit_bad_input, "cannot read " + file.string());
  return {std::istreambuf_iterator<char>(stream), {}};
}

void apply_settings(nlohmann::json& document, const std::vector<std::string>& settings) {
  for (const std::string& setting : settings) {
    const auto equals = setting.find('=');
    if (equals == std::string::npos || setting.empty() || setting.front() != '/') {
      throw CommandError(exit_bad_input, "--set takes /json/pointer=value, not " + setting);
    }
    const std::string text = setting.substr(equals + 1);
    auto value = nlohmann::json::parse(text, nullptr, false);
    if (value.is_discarded()) value = text;
    try {
      document[nlohmann::json::json_pointer(setting.substr(0, equals))] = value;
    } catch (const nlohmann::json::exception&) {
      throw CommandError(exit_bad_input, "--set " + setting + ": the case has no such place");
    }
  }
}

}  // namespace rouleau::service
