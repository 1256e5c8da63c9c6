#include "service/commands/sweep_here.h"

#include <chrono>
#include <condition_variable>
#include <iostream>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/simulation/run.h"
#include "service/commands/command.h"
#include "service/commands/local_sweep.h"
#include "service/commands/progress_line.h"
#include "service/commands/sweep_files.h"
#include "service/http/problem.h"
#include "service/interrupt.h"
#include "service/known_machine.h"
#include "service/sweep/sweep_body.h"
#include "service/sweep/sweep_picture.h"
#include "storage/sqlite/folder_lock.h"

namespace rouleau::service {

namespace {

const char* name_of(LocalSweep::State state) {
  switch (state) {
    case LocalSweep::State::succeeded:
      return "succeeded";
    case LocalSweep::State::failed:
      return "failed";
    case LocalSweep::State::waiting:
      break;
  }
  return "waiting";
}

SweepTable table_of(const SweepBody& sweep, const std::vector<SweepPoint>& points, const LocalSweep& ran) {
  std::vector<std::string> pointers;
  for (const Axis& axis : sweep.axes) pointers.push_back(axis.pointer);
  std::vector<SweepRow> rows;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const LocalSweep::Point& point = ran.points()[k];
    rows.push_back(
        {k, "", point.case_hash, values_at(sweep, points[k].choice), name_of(point.state), point.summary});
  }
  return make_table(pointers, rows);
}

/// Shows how far a sweep is until it goes.
class SweepProgress {
 public:
  explicit SweepProgress(const LocalSweep& sweep)
      : sweep_(sweep), thread_([this](const std::stop_token& stop) { show(stop); }) {}

 private:
  void show(const std::stop_token& stop) {
    ProgressLine line;
    const auto begun = std::chrono::steady_clock::now();
    std::mutex mutex;
    std::unique_lock lock(mutex);
    do {
      const LocalSweep::Standing now = sweep_.standing();
      const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begun;
      const double left = now.fraction > 0 ? passed.count() * (1 - now.fraction) / now.fraction : -1;
      line.show(now.fraction, fmt::format("{} of {} points  {} running  {} failed  {} left", now.done,
                                          now.points, now.running, now.failed, format_time_left(left)));
    } while (!stopped_.wait_for(lock, stop, std::chrono::milliseconds(200),
                                [&] { return stop.stop_requested(); }));
  }

  const LocalSweep& sweep_;
  std::condition_variable_any stopped_;
  std::jthread thread_;
};

void print_failures(const LocalSweep& sweep) {
  for (std::size_t k = 0; k < sweep.points().size(); ++k) {
    const LocalSweep::Point& point = sweep.points()[k];
    if (point.state == LocalSweep::State::failed) {
      std::cerr << fmt::format("error: point {}: {}\n", k, point.error);
    }
  }
}

}  // namespace

int sweep_here(const nlohmann::json& given, const std::filesystem::path& folder,
               const SweepHereOptions& options, bool json) {
  std::stop_source stop;
  const InterruptHandler interrupts([&stop] { stop.request_stop(); });
  // Of use to a service alone: the same file can be posted to one.
  const SweepBody body = read_sweep(given, options.most_points, {"priority", "labels", "fresh"});
  const std::vector<SweepPoint> points = expand(body);
  std::filesystem::create_directories(folder);
  const storage::FolderLock lock(folder);

  LocalSweep sweep(points, folder, KnownMachine(data_folder()).known());
  {
    const SweepProgress progress(sweep);
    sweep.run(options.workers, options.checkpoint_interval, stop.get_token());
  }
  const SweepTable table = table_of(body, points, sweep);
  write_sweep_files(folder, {{{"engine", engine_version()}, {"name", body.name}, {"sweep", given}},
                             to_json(table),
                             to_csv(table),
                             draw_sweep(table, body.axes.size())});
  const LocalSweep::Standing end = sweep.standing();
  print_failures(sweep);
  if (json) {
    std::cout << dump({{"folder", folder.string()},
                       {"points", end.points},
                       {"succeeded", end.done - end.failed},
                       {"failed", end.failed},
                       {"reused", end.reused},
                       {"table", to_json(table)}})
              << '\n';
  } else {
    std::cout << fmt::format("{} of {} points done, {} failed, {} were there already\ntable: {}\n", end.done,
                             end.points, end.failed, end.reused, (folder / "table.csv").string());
    if (end.done < end.points) std::cout << "the same command goes on\n";
  }
  return end.failed > 0 || end.done < end.points ? exit_failed : exit_done;
}

}  // namespace rouleau::service
