#pragma once

#include <memory>
#include <vector>

#include "engine/observe/observer.h"
#include "engine/plan/plan.h"
#include "engine/simulation/simulation.h"

namespace rouleau {

/// The observers that a plan calls for, in the catalogue's order, and what each of them takes.
class Observers {
 public:
  /// @param cell_free  called at most once for each observer that needs it, before this returns
  Observers(const Plan& plan, const effects::State& start, const observe::CellFreeFlow& cell_free);

  Recorded recorded(const Case& scene) const;
  void follow(const effects::State& state);
  Row sample(const effects::State& state);
  Frame draw(const effects::State& state);
  /// Into the summary, with the time that each took.
  void report(RunSummary& summary) const;

  void save(ByteWriter& bytes);
  void restore(ByteReader& bytes);

 private:
  struct Looking {
    const observe::ObserverKind* kind;
    std::unique_ptr<observe::Observer> observer;
    Usage usage;
  };

  /// Calls look(observer) for each, with its time taken.
  template <class Look>
  void for_each(Look look);

  std::vector<Looking> observers_;
};

}  // namespace rouleau
