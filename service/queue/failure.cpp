#include "service/queue/failure.h"

#include <array>
#include <new>
#include <system_error>

#include "engine/case/case_error.h"
#include "engine/error/simulation_error.h"
#include "storage/archive_error.h"
#include "storage/store_error.h"

namespace rouleau::service {

namespace {

using Kind = Failure::Kind;

nlohmann::json error_of(Kind kind, const char* message) {
  return {{"kind", to_string(kind)}, {"message", message}};
}

Failure from_simulation(const SimulationError& error) {
  const Breach& breach = error.breach();
  Failure failure{Kind::engine, error_of(Kind::engine, error.what())};
  failure.error.update({{"quantity", breach.quantity},
                        {"value", breach.value},
                        {"bound", breach.bound},
                        {"unit", breach.unit},
                        {"simulated_time", breach.time},
                        {"step", breach.step},
                        {"particle", breach.particle},
                        {"cell", breach.cell}});
  if (breach.has_place()) failure.error.update({{"x", breach.x}, {"y", breach.y}});
  return failure;
}

Failure from_case(const CaseError& error) {
  Failure failure{Kind::case_, error_of(Kind::case_, error.what())};
  auto& errors = failure.error["errors"] = nlohmann::json::array();
  for (const Fault& fault : error.faults()) {
    errors.push_back({{"pointer", fault.pointer}, {"message", fault.message}});
  }
  return failure;
}

bool is_infrastructure(const std::exception& error) {
  if (const auto* archive = dynamic_cast<const storage::ArchiveError*>(&error)) {
    return archive->kind() == storage::ArchiveError::Kind::disk_full ||
           archive->kind() == storage::ArchiveError::Kind::io;
  }
  return dynamic_cast<const storage::StoreError*>(&error) != nullptr ||
         dynamic_cast<const std::system_error*>(&error) != nullptr ||
         dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
}

}  // namespace

std::string_view to_string(Kind kind) {
  switch (kind) {
    case Kind::case_:
      return "case";
    case Kind::engine:
      return "engine";
    case Kind::infrastructure:
      return "infrastructure";
  }
  return "engine";
}

Failure failure_of(const std::exception& error) {
  if (const auto* unstable = dynamic_cast<const SimulationError*>(&error)) return from_simulation(*unstable);
  if (const auto* invalid = dynamic_cast<const CaseError*>(&error)) return from_case(*invalid);
  const Kind kind = is_infrastructure(error) ? Kind::infrastructure : Kind::engine;
  return {kind, error_of(kind, error.what())};
}

std::optional<std::chrono::seconds> retry_after(int setbacks) {
  static constexpr std::array<std::chrono::seconds, 4> gaps{
      std::chrono::seconds(5), std::chrono::seconds(20), std::chrono::seconds(60), std::chrono::seconds(180)};
  if (setbacks < 1 || static_cast<std::size_t>(setbacks) > gaps.size()) return std::nullopt;
  return gaps[static_cast<std::size_t>(setbacks) - 1];
}

}  // namespace rouleau::service
