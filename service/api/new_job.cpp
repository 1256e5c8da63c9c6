#include "service/api/new_job.h"

#include <cstddef>
#include <vector>

#include "engine/case/case_json.h"
#include "engine/case/faults.h"
#include "service/api/case_body.h"
#include "service/case_hash.h"

namespace rouleau::service {

namespace {

constexpr int greatest_priority = 100;
constexpr std::size_t most_labels = 16;
constexpr std::size_t longest_label_key = 64;
constexpr std::size_t longest_label_value = 256;

void read_priority(const nlohmann::json& value, storage::NewJob& job, std::vector<Fault>& faults) {
  if (!value.is_number_integer() || value < -greatest_priority || value > greatest_priority) {
    faults.push_back({"/priority", "must be a whole number from -" + std::to_string(greatest_priority) +
                                       " to " + std::to_string(greatest_priority)});
    return;
  }
  job.priority = value.get<int>();
}

void read_labels(const nlohmann::json& value, storage::NewJob& job, std::vector<Fault>& faults) {
  if (!value.is_object()) {
    faults.push_back({"/labels", "must be an object of texts"});
    return;
  }
  if (value.size() > most_labels) {
    faults.push_back({"/labels", "at most " + std::to_string(most_labels) + " labels"});
  }
  for (const auto& [key, label] : value.items()) {
    const std::string pointer = pointer_to("/labels", key);
    if (key.empty() || key.size() > longest_label_key || key.find(':') != std::string::npos) {
      faults.push_back(
          {pointer, "a label's key has 1 to " + std::to_string(longest_label_key) + " bytes and no colon"});
    }
    if (!label.is_string() || label.get_ref<const std::string&>().size() > longest_label_value) {
      faults.push_back(
          {pointer, "must be a text of at most " + std::to_string(longest_label_value) + " bytes"});
    }
  }
  job.labels = dump(value);
}

void read_fresh(const nlohmann::json& value, storage::NewJob& job, std::vector<Fault>& faults) {
  if (value.is_boolean()) {
    job.fresh = value.get<bool>();
  } else {
    faults.push_back({"/fresh", "must be true or false"});
  }
}

}  // namespace

storage::NewJob read_job_settings(const nlohmann::json& document, std::vector<Fault>& faults) {
  storage::NewJob job;
  if (!document.is_object()) return job;
  if (const auto value = document.find("priority"); value != document.end()) {
    read_priority(*value, job, faults);
  }
  if (const auto value = document.find("labels"); value != document.end()) read_labels(*value, job, faults);
  if (const auto value = document.find("fresh"); value != document.end()) read_fresh(*value, job, faults);
  return job;
}

std::string lane_of(const std::string& caller, const std::string& labels) {
  if (!caller.empty()) return caller;
  return nlohmann::json::parse(labels).value("lane", "");
}

storage::NewJob read_new_job(const Call& call, KnownMachine& machine) {
  const nlohmann::json document = read_body(call.request.body);
  if (!document.is_object())
    throw Problem(problems::invalid_request, "the body must be an object", {{"", "must be an object"}});

  std::vector<Fault> faults;
  storage::NewJob job = read_job_settings(document, faults);
  for (const auto& [key, value] : document.items()) {
    if (key != "case" && key != "priority" && key != "labels" && key != "fresh") {
      faults.push_back({pointer_to("", key), "unknown key; allowed: case, priority, labels, fresh"});
    }
  }
  if (!document.contains("case")) {
    faults.push_back({"/case", "is missing"});
    throw Problem(problems::invalid_request, "the body is not a job", std::move(faults));
  }
  try {
    const PlannedCase planned = plan_case(document["case"], "/case", &machine);
    job.name = planned.resolved.name;
    job.case_hash = case_hash(planned.resolved);
    job.case_given = document["case"].dump();
    job.case_resolved = to_json(planned.resolved).dump();
    job.plan = to_json(planned.plan).dump();
  } catch (const Problem& problem) {
    faults.insert(faults.end(), problem.faults().begin(), problem.faults().end());
    throw Problem(problem.kind(), problem.detail(), std::move(faults));
  }
  if (!faults.empty()) throw Problem(problems::invalid_request, "the body is not a job", std::move(faults));
  job.lane = lane_of(call.caller, job.labels);
  return job;
}

}  // namespace rouleau::service
