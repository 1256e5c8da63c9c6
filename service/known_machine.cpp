#include "service/known_machine.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>
#include <system_error>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "engine/simd/kernels.h"
#include "engine/simulation/calibration.h"
#include "engine/simulation/run.h"

namespace rouleau::service {

namespace {

/// Its name, and what Rouleau makes of it.
std::string processor() {
  std::ifstream told("/proc/cpuinfo");
  std::string line, name = "unknown";
  while (std::getline(told, line)) {
    if (!line.starts_with("model name")) continue;
    if (const auto colon = line.find(": "); colon != std::string::npos) name = line.substr(colon + 2);
    break;
  }
  return name + (simd::path() == simd::Path::avx2 ? ", avx2 kernels" : ", plain kernels");
}

std::filesystem::path file_in(const std::filesystem::path& data_folder) {
  const char* const file = std::getenv("ROULEAU_MACHINE");
  return file != nullptr && *file != '\0' ? std::filesystem::path(file) : data_folder / "machine.json";
}

}  // namespace

std::filesystem::path default_data_folder() {
  if (const char* const data = std::getenv("XDG_DATA_HOME"); data != nullptr && *data != '\0') {
    return std::filesystem::path(data) / "rouleau";
  }
  const char* const home = std::getenv("HOME");
  return std::filesystem::path(home == nullptr ? "." : home) / ".local/share/rouleau";
}

std::filesystem::path data_folder() {
  const char* const data = std::getenv("ROULEAU_DATA");
  return data != nullptr && *data != '\0' ? std::filesystem::path(data) : default_data_folder();
}

KnownMachine::KnownMachine(const std::filesystem::path& data_folder) : file_(file_in(data_folder)) {}

std::optional<Machine> KnownMachine::kept() const {
  std::ifstream in(file_);
  const auto told = nlohmann::json::parse(in, nullptr, false);
  // Whatever the file holds: anything but this engine and processor has it measured again.
  const auto says = [&](const char* key, const std::string& text) {
    const auto found = told.find(key);
    return found != told.end() && *found == text;
  };
  if (!told.is_object() || !says("engine", engine_version()) || !says("processor", processor())) {
    return std::nullopt;
  }
  const auto slowness = told.find("slowness");
  if (slowness == told.end() || !slowness->is_number()) return std::nullopt;
  const Machine machine{slowness->get<double>(), true};
  return std::isfinite(machine.slowness) && machine.slowness > 0 ? std::optional(machine) : std::nullopt;
}

Machine KnownMachine::known() {
  const std::lock_guard lock(mutex_);
  if (!machine_) machine_ = kept();
  return machine_.value_or(Machine{});
}

Machine KnownMachine::get() {
  const std::lock_guard lock(mutex_);
  if (!machine_) machine_ = kept();
  return machine_ ? *machine_ : measure_and_keep();
}

Machine KnownMachine::measure() {
  const std::lock_guard lock(mutex_);
  return measure_and_keep();
}

Machine KnownMachine::measure_and_keep() {
  machine_ = measure_machine();
  const nlohmann::json told = {
      {"engine", engine_version()}, {"processor", processor()}, {"slowness", machine_->slowness}};
  // Aside and renamed: whoever reads it at the same time reads a whole one.
  const std::filesystem::path aside = file_.string() + "." + std::to_string(getpid());
  std::error_code failed;
  std::filesystem::create_directories(file_.parent_path(), failed);
  if (std::ofstream out(aside); out << told.dump(2) << '\n') {
    out.close();
    std::filesystem::rename(aside, file_, failed);
  }
  return *machine_;
}

}  // namespace rouleau::service
