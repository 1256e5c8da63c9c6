#pragma once

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "engine/bytes/byte_stream.h"
#include "engine/effects/effect.h"
#include "engine/observe/record.h"
#include "engine/observe/run_summary.h"

namespace rouleau::observe {

/// Something that is looked at while a run lasts. It reads the state and never changes it.
class Observer {
 public:
  virtual ~Observer() = default;
  /// What it records beside its columns.
  virtual void describe(Recorded&) const {}
  /// After every step.
  virtual void follow(const effects::State&) {}
  /// At the times of the series: appends its columns' values.
  virtual void sample(const effects::State&, Row&) {}
  /// At the times of the frames.
  virtual void draw(const effects::State&, Frame&) {}
  /// At the end: what it found out.
  virtual void report(RunSummary&) const {}
  /// What it has gathered from step to step, for a checkpoint.
  virtual void save(ByteWriter&) {}
  virtual void restore(ByteReader&) {}
};

/// Gives the settled flow of the same vessel without its cells. It takes as long as a run's start.
using CellFreeFlow = std::function<std::unique_ptr<const effects::State>()>;

/// What an observer takes.
struct ObserverCost {
  effects::Cost start{};  ///< once
  effects::Cost step{};   ///< to follow it
  effects::Cost row{};    ///< of the series
  effects::Cost frame{};  ///< with its way into the archive
};

/// What the catalogue knows of an observer. It stands beside the observer's code.
struct ObserverKind {
  std::string_view name;
  bool optional;  ///< a case may switch it off (or, where the scene can carry it, on)
  effects::Need (*need)(const Case& scene);
  std::unique_ptr<Observer> (*make)(const effects::State& start, const CellFreeFlow& cell_free);
  /// Of the series; none: it has none.
  std::vector<Column> (*columns)(const Case& scene) = nullptr;
  std::vector<effects::Parameter> parameters = {};
  ObserverCost cost = {};
};

/// Every observer there is, in the order of their columns.
const std::vector<const ObserverKind*>& catalogue();

}  // namespace rouleau::observe
