#include <algorithm>
#include <bit>
#include <ctime>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "engine/effects/effect.h"
#include "engine/observe/observer.h"
#include "engine/plan/plan.h"
#include "engine/simulation/run.h"
#include "tests/allocation/counting_new.h"

namespace {

using namespace rouleau;

constexpr const char* usage =
    "usage: absent_run CASE.json STEPS\n\n"
    "Runs a case for about so many steps and prints, as one line of JSON, which effects this program knows "
    "and\n"
    "which of them ran, how often each was awake and what it took, the processor's time from the first step "
    "on,\n"
    "how much was allocated, and a digest of every bit of the answer. Programs that know fewer effects than\n"
    "all must print the same digest wherever the scene does without those.\n";

/// Of everything that a run delivers, bit by bit (FNV-1a).
class Digest : public Output {
 public:
  void begin(const RunHeader& header) override {
    for (const Column& column : header.columns) {
      for (const char c : column.name) add(static_cast<unsigned char>(c));
    }
    started_ = std::clock();
    allocations_ = allocations();
    allocated_ = allocated_bytes();
  }
  void series_row(std::span<const double> row) override {
    for (const double value : row) add(std::bit_cast<std::uint64_t>(value));
  }
  void probe_row(double, std::span<const ProbeValues> probes) override {
    for (const ProbeValues& probe : probes) add(std::bit_cast<std::uint64_t>(probe.flux));
  }
  void frame(const Frame& frame) override {
    for (const auto* values : {&frame.x, &frame.y, &frame.u, &frame.v, &frame.p}) {
      for (const float value : *values) add(std::bit_cast<std::uint32_t>(value));
    }
  }

  std::uint64_t value() const { return hash_; }
  double seconds() const { return static_cast<double>(std::clock() - started_) / CLOCKS_PER_SEC; }
  long allocations_since() const { return allocations() - allocations_; }
  long allocated_since() const { return allocated_bytes() - allocated_; }

 private:
  void add(std::uint64_t value) {
    for (int k = 0; k < 8; ++k, value >>= 8) hash_ = (hash_ ^ (value & 0xff)) * 0x100000001b3;
  }

  std::uint64_t hash_ = 0xcbf29ce484222325;
  std::clock_t started_ = 0;
  long allocations_ = 0, allocated_ = 0;
};

nlohmann::json known_effects() {
  nlohmann::json names = nlohmann::json::array();
  for (const effects::EffectKind* kind : effects::catalogue()) names.push_back(kind->name);
  for (const observe::ObserverKind* kind : observe::catalogue()) names.push_back(kind->name);
  return names;
}

nlohmann::json run(const std::string& file, long steps) {
  std::ifstream stream(file);
  const std::string text((std::istreambuf_iterator<char>(stream)), {});
  Case scene = read_case(text, check_effects);
  const Plan plan = make_plan(scene);
  scene.duration = static_cast<double>(std::min(steps, plan.steps)) * plan.time_step;
  scene.numerics.time_step = plan.time_step;
  Digest digest;
  const RunSummary summary = run_case(scene, digest);
  const double seconds = digest.seconds();
  return {{"name", scene.name},
          {"particles", plan.particles},
          {"membrane_nodes", plan.membrane_nodes},
          {"steps", summary.steps},
          {"seconds", seconds},
          {"steps_per_second", static_cast<double>(summary.steps) / seconds},
          {"allocations", digest.allocations_since()},
          {"allocated", digest.allocated_since()},
          {"digest", std::to_string(digest.value())},
          {"known", known_effects()},
          {"effects", to_json(summary).at("effect_times")}};
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 3) {
    std::cerr << usage;
    return 2;
  }
  std::cout << run(argv[1], std::stol(argv[2])).dump() << '\n';
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
