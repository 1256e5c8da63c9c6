#include "service/api/job_events.h"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "service/api/job_data.h"
#include "service/api/job_json.h"
#include "service/api/series_table.h"
#include "service/http/problem.h"
#include "service/queue/progress_json.h"

namespace rouleau::service {

namespace {

std::size_t row_count(const storage::SeriesTable& table) {
  return table.values.empty() ? 0 : table.values.front().size();
}

storage::SeriesTable part_of(const storage::SeriesTable& table, std::size_t first, std::size_t most) {
  std::vector<std::size_t> rows;
  for (std::size_t row = first; row < row_count(table) && rows.size() < most; ++row) rows.push_back(row);
  return select_rows(table, rows);
}

}  // namespace

JobEvents::JobEvents(Service& service, std::string id, const EventPlace& from)
    : service_(service), id_(std::move(id)), place_{from.rows, {}} {}

std::string JobEvents::next() {
  if (!look()) return {};
  std::string text;
  const bool ended = storage::has_ended(job_->state);
  if (!ended) text += state_event();
  const storage::SeriesTable rows = new_rows();
  text += series_event(rows);
  if (row_count(rows) == most_rows) return text;
  text += progress_event();
  if (ended) {
    place_.ended = job_->ended_at;
    text += state_event();
    over_ = true;
  }
  return text;
}

void JobEvents::wait(SignalBoard::Clock::time_point deadline) {
  service_.queue.changes().wait(seen_, deadline);
}

/// @return false if the job is gone
bool JobEvents::look() {
  const auto version = service_.queue.changes().version();
  if (!job_ || version != seen_) {
    seen_ = version;
    job_ = service_.store.find(id_);
    over_ = !job_;
  }
  // That of a run that has just ended is kept: it has the last rows.
  if (auto live = service_.queue.live().find(id_)) live_ = std::move(live);
  return job_.has_value();
}

storage::SeriesTable JobEvents::new_rows() {
  if (live_) return live_->series(place_.rows, most_rows);
  if (!stored_ || (row_count(*stored_) == 0 && job_->archive_size))
    stored_ = JobData(service_, *job_).series();
  return part_of(*stored_, place_.rows, most_rows);
}

std::string JobEvents::state_event() {
  nlohmann::json json = to_json(*job_, service_.queue.live());
  const auto progress = json.find("progress");
  nlohmann::json now = std::exchange(*progress, nullptr);
  std::string without_progress = dump(json);
  if (without_progress == last_state_) return {};
  last_state_ = std::move(without_progress);
  *progress = std::move(now);
  return event("state", dump(json));
}

std::string JobEvents::progress_event() {
  const auto progress = live_ ? live_->progress() : std::nullopt;
  if (!progress || progress->steps == last_steps_) return {};
  last_steps_ = progress->steps;
  return event("progress", dump(to_json(*progress)));
}

std::string JobEvents::series_event(const storage::SeriesTable& rows) {
  if (row_count(rows) == 0) return {};
  nlohmann::json json = series_json(rows);
  json["from"] = place_.rows;
  if (columns_told_) {
    json.erase("columns");
    json.erase("units");
  }
  columns_told_ = true;
  place_.rows += row_count(rows);
  return event("series", dump(json));
}

std::string JobEvents::event(const char* name, const std::string& data) const {
  return "id: " + to_event_id(place_) + "\nevent: " + name + "\ndata: " + data + "\n\n";
}

}  // namespace rouleau::service
