#include "service/commands/sweep_there.h"

#include <chrono>
#include <iostream>
#include <set>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "service/client/server_error.h"
#include "service/commands/command.h"
#include "service/commands/fetch_archive.h"
#include "service/commands/local_sweep.h"
#include "service/commands/progress_line.h"
#include "service/commands/sweep_files.h"
#include "service/http/problem.h"
#include "service/sweep/sweep_picture.h"
#include "service/sweep/sweep_table.h"

namespace rouleau::service {

namespace {

std::size_t points_of(const nlohmann::json& sweep) {
  std::size_t points = 0;
  for (const auto& count : sweep.at("counts")) points += count.get<std::size_t>();
  return points;
}

/// Follows a sweep until none of its jobs is active, showing how far it is.
nlohmann::json follow(ApiClient& client, const std::string& path) {
  ProgressLine line;
  const auto begun = std::chrono::steady_clock::now();
  std::size_t ended_before = 0;
  for (bool first = true;; first = false) {
    auto sweep = client.get(path + "?jobs=false" + (first ? "" : "&wait=2s"));
    const std::size_t points = points_of(sweep), active = sweep.at("active");
    const std::size_t ended = points - active;
    if (first) ended_before = ended;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begun;
    const auto since = static_cast<double>(ended - ended_before);
    const double left = since > 0 ? passed.count() / since * static_cast<double>(active) : -1;
    line.show(points == 0 ? 1 : static_cast<double>(ended) / static_cast<double>(points),
              fmt::format("{} of {} points  {} failed  {} left", ended, points,
                          sweep["counts"]["failed"].get<std::size_t>(), format_time_left(left)));
    if (active == 0) return sweep;
  }
}

/// The archives of all points that have one, named as a sweep here would name them: it finds them then.
std::size_t fetch_archives(ApiClient& client, const SweepTable& table, const std::filesystem::path& folder) {
  ProgressLine line;
  std::set<std::string> fetched;
  for (const auto& row : table.rows) {
    const std::string job = row.at(1), hash = row.at(2);
    line.show(static_cast<double>(fetched.size()) / static_cast<double>(table.rows.size()),
              fmt::format("{} of {} archives", fetched.size(), table.rows.size()));
    if (fetched.contains(hash)) continue;
    try {
      fetch_archive(client, job, sweep_archive(folder, hash));
      fetched.insert(hash);
    } catch (const ServerError& error) {
      if (!has_no_archive(error)) throw;
    }
  }
  return fetched.size();
}

}  // namespace

int sweep_there(ApiClient& client, const nlohmann::json& given, const std::filesystem::path& folder,
                bool wait, bool json) {
  auto sweep = client.post_once("/v1/sweeps", given, new_idempotency_key());
  const std::string path = sweep_path(sweep.at("id"));
  if (!json) std::cout << sweep.at("id").get<std::string>() << '\n' << client.url() << path << std::endl;
  if (wait || !folder.empty()) sweep = follow(client, path);
  if (!folder.empty()) {
    std::filesystem::create_directories(folder);
    const SweepTable table = read_table(client.get(path + "/table"));
    const std::size_t archives = fetch_archives(client, table, folder);
    write_sweep_files(folder, {{{"name", sweep.at("name")}, {"id", sweep.at("id")}, {"sweep", given}},
                               to_json(table),
                               to_csv(table),
                               draw_sweep(table, sweep.at("axes").size())});
    if (!json) {
      std::cout << fmt::format("{} archives and the table: {}\n", archives, (folder / "table.csv").string());
    }
  }
  if (json) std::cout << dump(sweep) << '\n';
  if (!wait && folder.empty()) return exit_done;
  if (!json) {
    for (const auto& [state, count] : sweep.at("counts").items()) {
      if (count != 0) std::cout << dump(count) << ' ' << state << '\n';
    }
  }
  return sweep["counts"]["succeeded"] == points_of(sweep) ? exit_done : exit_failed;
}

}  // namespace rouleau::service
