#include <chrono>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "tests/validation/references.h"
#include "tests/validation/scenes.h"

namespace {

using namespace rouleau;
using namespace rouleau::validation;

constexpr const char* usage =
    "usage: validation_run SCENE [ACROSS [standard|paper]]\n"
    "       validation_run --list\n\n"
    "Runs a scene with ACROSS (25) particle spacings over its height (of a cell in shear: over the cell's\n"
    "diameter) and prints, as one line of JSON, how\n"
    "far it is from its reference and what that took. A run that fails says so in the line; exit code 0.\n";

/// The run, and its time in s: by the clock, and of the processor.
nlohmann::json timed(const Scene& scene, const Resolution& resolution) {
  nlohmann::json line{{"scene", scene.name},
                      {"across", resolution.across},
                      {"preset", resolution.preset == Preset::paper ? "paper" : "standard"},
                      {"reference", reference(scene.reference).at("kind")}};
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpu_start = std::clock();
  try {
    const Measurement m = scene.run(resolution);
    line["outcome"] = "completed";
    line["simulated_time"] = m.simulated_time;
    line["steps"] = m.steps;
    line["errors"] = nlohmann::json::object();
    for (const auto& [name, value] : m.errors) line["errors"][name] = value;
    for (const auto& [name, value] : m.values) line["values"][name] = value;
  } catch (const std::exception& failure) {
    line["outcome"] = "failed";
    line["message"] = failure.what();
  }
  line["wall_time"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  line["cpu_time"] = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
  return line;
}

Resolution resolution_of(int arguments, char** values) {
  Resolution resolution;
  if (arguments > 2) resolution.across = std::stoi(values[2]);
  if (resolution.across < 8 || resolution.across > 1000)
    throw std::invalid_argument("ACROSS is from 8 to 1000");
  const std::string preset = arguments > 3 ? values[3] : "standard";
  if (preset != "standard" && preset != "paper") throw std::invalid_argument("no such preset: " + preset);
  if (preset == "paper") resolution.preset = Preset::paper;
  return resolution;
}

}  // namespace

int main(int arguments, char** values) {
  const std::string first = arguments > 1 ? values[1] : "";
  if (first == "--help" || first == "-h") {
    std::cout << usage;
    return EXIT_SUCCESS;
  }
  if (first == "--list") {
    for (const Scene& scene : scenes()) std::cout << scene.name << '\n';
    return EXIT_SUCCESS;
  }
  try {
    const Scene& scene = scene_named(first);
    std::cout << timed(scene, resolution_of(arguments, values)).dump() << std::endl;
    return EXIT_SUCCESS;
  } catch (const std::exception& wrong) {
    std::cerr << wrong.what() << '\n' << usage;
    return 2;
  }
}
