#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <iostream>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "engine/simulation/run.h"
#include "service/commands/case_file.h"
#include "service/commands/command.h"
#include "service/commands/local_sweep.h"
#include "service/commands/progress_line.h"
#include "service/commands/sweep_files.h"
#include "service/http/problem.h"
#include "service/interrupt.h"
#include "service/known_machine.h"
#include "service/sweep/sweep_body.h"
#include "storage/sqlite/folder_lock.h"

namespace rouleau::service {

namespace {

struct Options {
  std::string file;
  std::string folder;
  int workers = 1;
  double checkpoint_interval = 60;
  std::size_t most_points = default_most_points;
};

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

int sweep(const Options& options, bool json) {
  std::stop_source stop;
  const InterruptHandler interrupts([&stop] { stop.request_stop(); });
  const nlohmann::json given = parse_json(read_case_file(options.file));
  // Of use to a service alone: the same file can be posted to one.
  const SweepBody body = read_sweep(given, options.most_points, {"priority", "labels", "fresh"});
  const std::vector<SweepPoint> points = expand(body);
  const std::filesystem::path folder = options.folder.empty() ? std::filesystem::path(options.file).stem()
                                                              : std::filesystem::path(options.folder);
  std::filesystem::create_directories(folder);
  const storage::FolderLock lock(folder);

  LocalSweep sweep(points, folder, KnownMachine(data_folder()).known());
  {
    const SweepProgress progress(sweep);
    sweep.run(options.workers, options.checkpoint_interval, stop.get_token());
  }
  const SweepTable table = table_of(body, points, sweep);
  const nlohmann::json about{{"engine", engine_version()}, {"name", body.name}, {"sweep", given}};
  write_sweep_files(folder, about, to_json(table), to_csv(table));

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

}  // namespace

void add_sweep(CLI::App& app, Action& action) {
  auto* const command = app.add_subcommand(
      "sweep", "Run a case at many values on all cores; run again, it goes on where it stopped");
  const auto options = std::make_shared<Options>();
  options->workers = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  command->add_option("SWEEP.json", options->file, "The case and its axes")->required();
  command->add_option("-o,--output", options->folder,
                      "Folder of the archives, table.csv and sweep.json (default: the file's name, here)");
  command->add_option("--workers", options->workers, "Points run at a time")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command
      ->add_option("--checkpoint-interval", options->checkpoint_interval,
                   "Seconds between the checkpoints of a point; 0: none")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  command->add_option("--max-sweep", options->most_points, "The most points that are taken")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  command->add_flag("--json", action.json, "Print the table and the counts as JSON");
  command->callback(
      [&action, options] { action.run = [&action, options] { return sweep(*options, action.json); }; });
}

}  // namespace rouleau::service
