#include <iostream>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/simd/kernels.h"
#include "service/commands/bench_measure.h"
#include "service/commands/command.h"
#include "service/http/problem.h"

namespace rouleau::service {

namespace {

struct Options {
  std::vector<std::string> presets{"standard"};
  std::vector<int> particles{1000, 5000, 20000, 100000};
  int steps = 20;
};

const char* kernels_in_use() {
  return simd::path() == simd::Path::avx2 ? "avx2" : "plain";
}

nlohmann::json to_json(const BenchPoint& point) {
  nlohmann::json effects = nlohmann::json::array();
  for (const EffectTime& effect : point.effects) {
    effects.push_back({{"name", effect.name},
                       {"seconds", effect.seconds},
                       {"updates_per_second", updates_per_second(point, effect.seconds)}});
  }
  return {{"preset", point.preset},
          {"particles", point.particles},
          {"steps", point.steps},
          {"seconds", point.seconds},
          {"updates_per_second", updates_per_second(point, point.seconds)},
          {"effects", effects}};
}

/// A column a size, a row an effect; points of one preset.
void print(const std::vector<BenchPoint>& points) {
  std::cout << fmt::format("preset {}, {} kernels, {} steps; million particles x steps a second\n\n{:28}",
                           points.front().preset, kernels_in_use(), points.front().steps, "particles");
  for (const BenchPoint& point : points) std::cout << fmt::format("{:>10}", point.particles);
  for (std::size_t k = 0; k < points.front().effects.size(); ++k) {
    std::cout << fmt::format("\n{:28}", points.front().effects[k].name);
    for (const BenchPoint& point : points) {
      std::cout << fmt::format("{:>10.4g}", 1e-6 * updates_per_second(point, point.effects[k].seconds));
    }
  }
  std::cout << fmt::format("\n{:28}", "all");
  for (const BenchPoint& point : points) {
    std::cout << fmt::format("{:>10.4g}", 1e-6 * updates_per_second(point, point.seconds));
  }
  std::cout << fmt::format("\n{:28}", "ms a step");
  for (const BenchPoint& point : points) {
    std::cout << fmt::format("{:>10.4g}", 1e3 * point.seconds / point.steps);
  }
  std::cout << "\n\n";
}

int run(const Options& options, bool json) {
  nlohmann::json all = nlohmann::json::array();
  for (const std::string& preset : options.presets) {
    std::vector<BenchPoint> points;
    for (const int particles : options.particles) points.push_back(bench(preset, particles, options.steps));
    for (const BenchPoint& point : points) all.push_back(to_json(point));
    if (!json) print(points);
  }
  if (json) {
    std::cout << dump({{"version", engine_version()}, {"kernels", kernels_in_use()}, {"points", all}})
              << '\n';
  }
  return exit_done;
}

}  // namespace

void add_bench(CLI::App& app, Action& action) {
  auto* const command =
      app.add_subcommand("bench", "Measure particles x steps per second on this machine, by effect and size");
  const auto options = std::make_shared<Options>();
  command->add_option("--preset", options->presets, "Presets, separated by commas")
      ->delimiter(',')
      ->capture_default_str();
  command->add_option("--particles", options->particles, "Sizes, separated by commas")
      ->delimiter(',')
      ->check(CLI::Range(100, 10'000'000))
      ->capture_default_str();
  command->add_option("--steps", options->steps, "Steps that are timed")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  command->add_flag("--json", action.json, "Print what was measured as JSON");
  command->callback(
      [&action, options] { action.run = [&action, options] { return run(*options, action.json); }; });
}

}  // namespace rouleau::service
