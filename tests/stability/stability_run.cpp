#include <chrono>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "tests/stability/scenes.h"

namespace {

using namespace rouleau;
using namespace rouleau::stability;

constexpr const char* usage =
    "usage: stability_run SCENE [--short|--long]\n"
    "       stability_run --list\n\n"
    "Runs a scene that breaks solvers, in its short form unless told otherwise, looks at it after every "
    "step\n"
    "and prints, as one line of JSON, how it ended, the worst of each quantity watched (with its bound, and\n"
    "where and when) and what that took. A run that fails says so in the line; exit code 0.\n";

nlohmann::json to_json(const Report& report) {
  nlohmann::json worst = nlohmann::json::object();
  for (const auto& [name, w] : report.worst) {
    worst[name] = {{"value", w.value}, {"bound", w.bound}, {"time", w.time}, {"x", w.x}, {"y", w.y}};
  }
  return {{"outcome", report.outcome},
          {"message", report.message},
          {"misses", report.misses()},
          {"worst", worst},
          {"simulated_time", report.simulated_time},
          {"steps", report.steps},
          {"rejected", report.rejected},
          {"put_back", report.put_back},
          {"particles", report.particles}};
}

/// The run, and its time in s: by the clock, and of the processor.
nlohmann::json timed(const Scene& scene, Form form) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpu_start = std::clock();
  nlohmann::json line = to_json(scene.run(form));
  line["scene"] = scene.name;
  line["place"] = &scene - scenes().data();
  line["text"] = scene.text;
  line["form"] = form == Form::full ? "long" : "short";
  line["wall_time"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  line["cpu_time"] = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
  return line;
}

Form form_of(const std::string& option) {
  if (option.empty() || option == "--short") return Form::brief;
  if (option == "--long") return Form::full;
  throw std::invalid_argument("no such option: " + option);
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
    const Form form = form_of(arguments > 2 ? values[2] : "");
    std::cout << timed(scene_named(first), form).dump() << std::endl;
    return EXIT_SUCCESS;
  } catch (const std::exception& wrong) {
    std::cerr << wrong.what() << '\n' << usage;
    return 2;
  }
}
