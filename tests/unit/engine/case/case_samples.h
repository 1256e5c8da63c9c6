#pragma once

#include <fstream>
#include <iterator>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/case/case_error.h"
#include "engine/case/case_json.h"

namespace rouleau {

/// For GoogleTest's messages.
inline void PrintTo(const Fault& fault, std::ostream* stream) {
  *stream << fault.pointer << ": " << fault.message;
}

}  // namespace rouleau

namespace rouleau::testing {

/// The least that a case may say.
inline nlohmann::json minimal_case() {
  return {{"version", 1}, {"vessel", {{"length", 80e-6}, {"diameter", 10e-6}}}, {"duration", 1e-3}};
}

inline nlohmann::json thrombus(const char* wall, double x, double radius) {
  return {{"wall", wall}, {"x", x}, {"radius", radius}};
}

inline nlohmann::json cell(double x, double y, double angle = 90) {
  return {{"x", x}, {"y", y}, {"angle", angle}};
}

/// The study's section 3.1: a cell upstream of a thrombus.
inline nlohmann::json published_case() {
  nlohmann::json document = minimal_case();
  document["thrombi"] = {thrombus("lower", 32e-6, 3.2e-6)};
  document["cells"] = {cell(16e-6, 5e-6)};
  return document;
}

/// `minimal_case` in another vessel.
inline nlohmann::json case_in(const nlohmann::json& vessel) {
  nlohmann::json document = minimal_case();
  document["vessel"] = vessel;
  return document;
}

inline nlohmann::json periodic_case() {
  return case_in({{"length", 20e-6}, {"diameter", 10e-6}, {"ends", "periodic"}});
}

/// The study's section 3.3: a trunk and two branches alike.
inline nlohmann::json bifurcation_case() {
  return case_in({{"shape", "bifurcation"},
                  {"trunk", {{"length", 80e-6}, {"diameter", 20e-6}}},
                  {"branches", {{"length", 40e-6}, {"diameter", 10e-6}}}});
}

inline nlohmann::json box_case() {
  return case_in({{"shape", "box"}, {"width", 30e-6}, {"height", 20e-6}});
}

inline nlohmann::json vortex_case() {
  nlohmann::json document = box_case();
  document["vessel"]["ends"] = "periodic";
  document["initial"] = {{"flow", "taylor_green"}, {"velocity", 0.01}};
  return document;
}

inline nlohmann::json paper_case() {
  nlohmann::json document = minimal_case();
  document["numerics"] = {{"preset", "paper"}};
  return document;
}

/// One case of every kind that takes keys of its own.
inline std::vector<nlohmann::json> cases_of_every_kind() {
  return {published_case(), periodic_case(), bifurcation_case(), box_case(), vortex_case(), paper_case()};
}

/// The faults of a case given as text or as a document; none if it reads.
template <typename Input>
std::vector<Fault> faults_of(const Input& input) {
  try {
    read_case(input);
  } catch (const CaseError& error) {
    return error.faults();
  }
  return {};
}

inline std::vector<std::string> pointers(const std::vector<Fault>& faults) {
  std::vector<std::string> result;
  for (const Fault& fault : faults) result.push_back(fault.pointer);
  return result;
}

/// The message at `pointer`, "" if nothing was found there.
inline std::string message_at(const std::vector<Fault>& faults, std::string_view pointer) {
  for (const Fault& fault : faults) {
    if (fault.pointer == pointer) return fault.message;
  }
  return "";
}

/// `base` with the value at `pointer` replaced, or added.
inline nlohmann::json with(nlohmann::json base, const std::string& pointer, const nlohmann::json& value) {
  base[nlohmann::json::json_pointer(pointer)] = value;
  return base;
}

/// The path of the repository, with a / at its end.
inline std::string repository_root() {
  const std::string here = __FILE__;
  return here.substr(0, here.rfind("tests/unit/engine/case"));
}

/// A file of the repository, by its path from the root.
inline std::string repository_file(const std::string& path) {
  std::ifstream file(repository_root() + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace rouleau::testing
