#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "service/api/query.h"
#include "service/api/service.h"
#include "service/http/guarded_server.h"
#include "service/http/problem.h"
#include "service/queue/job_files.h"
#include "storage/archive_reader.h"

namespace rouleau::service {

namespace {

storage::ArchiveReader open_archive(Service& service, const Call& call) {
  const storage::Job job = find_finished(service, call);
  return storage::ArchiveReader(archive_of(service, job));
}

/// [T][points]; what is not finite is null.
nlohmann::json rows_json(const std::vector<double>& values, std::size_t points) {
  auto rows = nlohmann::json::array();
  for (std::size_t first = 0; first < values.size(); first += points) {
    auto& row = rows.emplace_back(nlohmann::json::array());
    for (std::size_t k = first; k < first + points; ++k) {
      row.push_back(std::isfinite(values[k]) ? nlohmann::json(values[k]) : nlohmann::json());
    }
  }
  return rows;
}

void list_probes(Service& service, const Call& call, httplib::Response& response) {
  check_query(call, {});
  answer_json({{"names", open_archive(service, call).probe_names()}}, response);
}

void get_probe(Service& service, const Call& call, httplib::Response& response) {
  check_query(call, {});
  const storage::ArchiveReader archive = open_archive(service, call);
  const std::string& name = call.part("name");
  const auto names = archive.probe_names();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    throw Problem(problems::not_found, "the job has no probe of this name");
  }
  const storage::ProbeTable probe = archive.probe(name);
  const std::size_t points = probe.x.size();
  nlohmann::json body{{"name", name},
                      {"x", probe.x},
                      {"y", probe.y},
                      {"time", probe.time},
                      {"u", rows_json(probe.u, points)},
                      {"v", rows_json(probe.v, points)},
                      {"p", rows_json(probe.p, points)}};
  if (!probe.flux.empty()) body["flux"] = probe.flux;
  answer_json(body, response);
}

}  // namespace

void add_probes(Router& router, Service& service) {
  router.add("GET", "/v1/jobs/{id}/probes", [&service](const Call& call, httplib::Response& response) {
    list_probes(service, call, response);
  });
  router.add("GET", "/v1/jobs/{id}/probes/{name}", [&service](const Call& call, httplib::Response& response) {
    get_probe(service, call, response);
  });
}

}  // namespace rouleau::service
