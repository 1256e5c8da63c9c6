#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "service/api/job_data.h"
#include "service/api/query.h"
#include "service/http/guarded_server.h"
#include "service/http/problem.h"

namespace rouleau::service {

namespace {

/// Seven digits are all that a float has.
nlohmann::json numbers(const std::vector<float>& values) {
  auto array = nlohmann::json::array();
  for (const float value : values) {
    if (std::isfinite(value)) {
      double shortest = 0;
      char text[32];
      const auto written = std::to_chars(text, text + sizeof(text), value);
      std::from_chars(text, written.ptr, shortest);
      array.push_back(shortest);
    } else {
      array.push_back(nullptr);
    }
  }
  return array;
}

nlohmann::json outlines_json(const std::vector<storage::Outline>& outlines) {
  auto array = nlohmann::json::array();
  for (const storage::Outline& outline : outlines) {
    nlohmann::json json{{"x", numbers(outline.x)}, {"y", numbers(outline.y)}};
    for (const auto& [name, values] : outline.fields) json[name] = numbers(values);
    array.push_back(std::move(json));
  }
  return array;
}

/// Fields that the run does not keep are left out.
nlohmann::json particles_json(const Frame& frame) {
  auto kinds = nlohmann::json::array();
  for (const ParticleKind kind : frame.kind) kinds.push_back(static_cast<int>(kind));
  nlohmann::json json{{"id", frame.id},
                      {"kind", std::move(kinds)},
                      {"cell", frame.cell},
                      {"x", numbers(frame.x)},
                      {"y", numbers(frame.y)}};
  for (const auto& [name, values] : {std::pair{"u", &frame.u}, {"v", &frame.v}, {"p", &frame.p}}) {
    if (!values->empty() || frame.id.empty()) json[name] = numbers(*values);
  }
  return json;
}

nlohmann::json walls_json(const WallNodes& walls, const Frame& frame) {
  return {{"x", walls.x},
          {"y", walls.y},
          {"arc_length", walls.arc_length},
          {"wall", walls.wall},
          {"shear_stress", numbers(frame.wall_shear_stress)}};
}

/// @return whether `fields=outlines` is asked for
bool outlines_alone(const Call& call) {
  const auto fields = query(call, "fields");
  if (fields && *fields != "outlines") {
    throw Problem(problems::invalid_request, "a query parameter is not valid",
                  {{"?fields", "allowed: outlines"}});
  }
  return fields.has_value();
}

void list_frames(Service& service, const Call& call, httplib::Response& response) {
  check_query(call, {"fields", "from"});
  const bool with_outlines = outlines_alone(call);
  const int from = query_integer(call, "from", 0, 1'000'000'000).value_or(0);
  const JobData data(service, find_job(service, call));
  const auto times = data.frame_times();
  nlohmann::json body{{"times", times}};
  if (with_outlines) {
    auto& outlines = body["outlines"] = nlohmann::json::array();
    for (int k = from; static_cast<std::size_t>(k) < times.size(); ++k) {
      outlines.push_back(outlines_json(data.outlines(k).value_or(std::vector<storage::Outline>{})));
    }
    body["from"] = from;
  }
  answer_json(body, response);
}

int read_frame_number(const Call& call) {
  const std::string& text = call.part("k");
  int k = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), k);
  if (error != std::errc{} || end != text.data() + text.size()) k = -1;
  return k;
}

void get_frame(Service& service, const Call& call, httplib::Response& response) {
  check_query(call, {"fields"});
  const bool without_particles = outlines_alone(call);
  const JobData data(service, find_job(service, call));
  const int k = read_frame_number(call);
  const auto outlines = data.outlines(k);
  if (!outlines) throw Problem(problems::not_found, "the job has no frame of this number");
  nlohmann::json body{{"k", k},
                      {"time", data.frame_times().at(static_cast<std::size_t>(k))},
                      {"outlines", outlines_json(*outlines)}};
  if (!without_particles) {
    const auto frame = data.frame(k);
    body["particles"] = frame ? particles_json(*frame) : nlohmann::json();
    if (frame && !frame->wall_shear_stress.empty()) body["walls"] = walls_json(data.walls(), *frame);
  }
  answer_json(body, response);
}

}  // namespace

void add_frames(Router& router, Service& service) {
  router.add("GET", "/v1/jobs/{id}/frames", [&service](const Call& call, httplib::Response& response) {
    list_frames(service, call, response);
  });
  router.add("GET", "/v1/jobs/{id}/frames/{k}", [&service](const Call& call, httplib::Response& response) {
    get_frame(service, call, response);
  });
}

}  // namespace rouleau::service
