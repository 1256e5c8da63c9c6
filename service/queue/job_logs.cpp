#include "service/queue/job_logs.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "service/time_text.h"
#include "storage/job_store.h"

namespace rouleau::service {

namespace {

std::string line_of(storage::TimeMs time, std::string_view event, log::Fields fields) {
  return format_time(time) + ' ' + log::format(event, fields) + '\n';
}

/// It stands at the head of every log, and is known before there is one.
std::string first_line(const storage::Job& job) {
  return line_of(job.created_at, "accepted",
                 {{"job", job.id}, {"name", job.name}, {"priority", std::to_string(job.priority)}});
}

/// A job that was given another's result did not run, and nobody wrote of it.
std::string last_line(const storage::Job& job) {
  if (!job.result_of || job.state != storage::JobState::succeeded) return {};
  return line_of(*job.ended_at, "succeeded", {{"result_of", *job.result_of}});
}

std::string line_now(std::string_view event, log::Fields fields) {
  return line_of(storage::system_clock_ms(), event, fields);
}

}  // namespace

JobLogs::JobLogs(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::filesystem::create_directories(folder_);
}

std::filesystem::path JobLogs::path(std::string_view id) const {
  return folder_ / (std::string(id) + ".log");
}

void JobLogs::note(const storage::Job& job, std::string_view event, log::Fields fields) {
  append(job, line_now(event, fields), largest, true);
}

void JobLogs::note_routine(const storage::Job& job, std::string_view event, log::Fields fields) {
  append(job, line_now(event, fields), routine_until, true);
}

void JobLogs::note_end(const storage::Job& job, std::string_view event, log::Fields fields) {
  append(job, line_now(event, fields), largest, false);
}

void JobLogs::append(const storage::Job& job, const std::string& line, std::uint64_t limit, bool begin) {
  const std::lock_guard lock(mutex_);
  const auto file = path(job.id);
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  const bool is_new = static_cast<bool>(error);
  if (is_new ? !begin : size + line.size() > limit) return;
  std::ofstream out(file, std::ios::binary | std::ios::app);
  if (is_new) out << first_line(job);
  out << line;
  out.close();
  if (!out) log::warn("a job's log could not be written", {{"job", job.id}});
}

std::string JobLogs::read(const storage::Job& job, std::uint64_t from) const {
  std::ifstream file(path(job.id), std::ios::binary);
  std::string text = file ? std::string(std::istreambuf_iterator<char>(file), {}) : first_line(job);
  text += last_line(job);
  return text.substr(std::min<std::uint64_t>(from, text.size()));
}

void JobLogs::remove(std::string_view id) {
  const std::lock_guard lock(mutex_);
  std::error_code ignored;
  std::filesystem::remove(path(id), ignored);
}

}  // namespace rouleau::service
