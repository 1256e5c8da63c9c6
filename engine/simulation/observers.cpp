#include "engine/simulation/observers.h"

#include <chrono>

#include "engine/simulation/lasting.h"

namespace rouleau {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

Observers::Observers(const Plan& plan, const effects::State& start, const observe::CellFreeFlow& cell_free) {
  for (const observe::ObserverKind* kind : observe::catalogue()) {
    if (!runs(plan, kind->name)) continue;
    const auto begun = Clock::now();
    observers_.push_back({kind, kind->make(start, cell_free), {}});
    observers_.back().usage.seconds = seconds_since(begun);
  }
}

template <class Look>
void Observers::for_each(Look look) {
  for (Looking& looking : observers_) {
    const auto start = Clock::now();
    look(*looking.observer);
    looking.usage.seconds += seconds_since(start);
    ++looking.usage.rounds;
    ++looking.usage.awake;
  }
}

Recorded Observers::recorded(const Case& scene) const {
  Recorded recorded;
  for (const Looking& looking : observers_) {
    if (looking.kind->columns) {
      for (Column& column : looking.kind->columns(scene)) recorded.columns.push_back(std::move(column));
    }
    looking.observer->describe(recorded);
  }
  return recorded;
}

void Observers::follow(const effects::State& state) {
  for_each([&](observe::Observer& observer) { observer.follow(state); });
}

Row Observers::sample(const effects::State& state) {
  Row row;
  for_each([&](observe::Observer& observer) { observer.sample(state, row); });
  return row;
}

Frame Observers::draw(const effects::State& state) {
  Frame frame;
  for_each([&](observe::Observer& observer) { observer.draw(state, frame); });
  return frame;
}

void Observers::report(RunSummary& summary) const {
  for (const Looking& looking : observers_) {
    looking.observer->report(summary);
    summary.effect_times.push_back(
        {std::string(looking.kind->name), looking.usage.seconds, looking.usage.rounds, looking.usage.awake});
  }
}

void Observers::save(ByteWriter& bytes) {
  for (Looking& looking : observers_) {
    bytes(looking.usage);
    looking.observer->save(bytes);
  }
}

void Observers::restore(ByteReader& bytes) {
  for (Looking& looking : observers_) {
    bytes(looking.usage);
    looking.observer->restore(bytes);
  }
}

}  // namespace rouleau
