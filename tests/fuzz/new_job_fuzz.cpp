#include <filesystem>

#include <nlohmann/json.hpp>

#include "service/api/idempotency.h"
#include "service/api/new_job.h"
#include "service/http/problem.h"
#include "tests/fuzz/targets.h"

namespace rouleau::fuzz {

/// The Idempotency-Key, a line end, the body.
void new_job(std::string_view input) {
  static service::KnownMachine machine(std::filesystem::temp_directory_path());
  const auto line_end = input.find('\n');
  if (line_end == std::string_view::npos) return;
  httplib::Request request;
  request.headers.emplace("Idempotency-Key", std::string(input.substr(0, line_end)));
  request.body = input.substr(line_end + 1);
  const service::Call call{request, {}, "", ""};
  try {
    const auto key = service::idempotency_key(call);
    must(key && !key->key.empty());
    const auto job = service::read_new_job(call, machine);
    must(job.case_hash.size() == 64);
    service::lane_of("", job.labels);
  } catch (const service::Problem& problem) {
    service::dump(service::to_json(problem, ""));
  }
}

}  // namespace rouleau::fuzz
