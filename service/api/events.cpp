#include <chrono>
#include <exception>
#include <memory>
#include <string>
#include <thread>

#include "service/api/job_events.h"
#include "service/api/query.h"
#include "service/api/service.h"
#include "service/http/problem.h"
#include "service/log.h"

namespace rouleau::service {

namespace {

using Clock = SignalBoard::Clock;

// Rows and progress are looked for this often.
constexpr std::chrono::milliseconds interval{250};
// Between two looks at the store, however much happens to other jobs.
constexpr std::chrono::milliseconds least_interval{50};
constexpr const char* reconnect_after = "retry: 2000\n\n";

/// One of the streams that may be open at a time.
class Stream {
 public:
  Stream(Service& service, const std::string& id, const EventPlace& from)
      : service_(service), events_(service, id, from), ends_at_(Clock::now() + service.streams.longest) {
    if (++service_.streams.open <= service_.streams.most) return;
    --service_.streams.open;
    throw Problem(problems::too_many_streams,
                  "as many streams are open as may be; GET the job with wait, or try again");
  }
  ~Stream() { --service_.streams.open; }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  /// Sends what is new, or waits a moment for it.
  /// @return false once nobody listens
  bool work(httplib::DataSink& sink) {
    if (!sink.is_writable()) return false;
    const bool ends =
        events_.over() || service_.draining || Clock::now() >= ends_at_ || service_.streams.epoch != epoch_;
    if (ends) {
      sink.done();
      return true;
    }
    std::string text = begun_ ? events_.next() : reconnect_after + events_.next();
    begun_ = true;
    const auto now = Clock::now();
    if (text.empty() && now >= sent_at_ + service_.streams.comment_interval) text = ": still here\n\n";
    if (!text.empty()) {
      sent_at_ = now;
      if (!sink.write(text.data(), text.size())) return false;
    }
    if (events_.over()) return true;
    if (now < looked_at_ + least_interval) std::this_thread::sleep_until(looked_at_ + least_interval);
    events_.wait(now + interval);
    looked_at_ = Clock::now();
    return true;
  }

 private:
  Service& service_;
  JobEvents events_;
  const Clock::time_point ends_at_;
  const int epoch_ = service_.streams.epoch;
  Clock::time_point sent_at_ = Clock::now();
  Clock::time_point looked_at_;
  bool begun_ = false;
};

void get_events(Service& service, const Call& call, httplib::Response& response) {
  check_query(call, {});
  const storage::Job job = find_job(service, call);
  const EventPlace from = parse_event_id(call.request.get_header_value("Last-Event-ID"));
  if (from.ended && from.ended == job.ended_at) {
    // A browser that was told of the end connects again until it gets this.
    response.status = 204;
    return;
  }
  const auto stream = std::make_shared<Stream>(service, job.id, from);
  response.set_header("X-Accel-Buffering", "no");
  response.set_chunked_content_provider(
      "text/event-stream", [stream, request = call.request_id](std::size_t, httplib::DataSink& sink) {
        try {
          return stream->work(sink);
        } catch (const std::exception& error) {
          log::error("event stream ended", {{"request", request}, {"error", error.what()}});
          return false;
        }
      });
}

}  // namespace

void add_events(Router& router, Service& service) {
  router.add("GET", "/v1/jobs/{id}/events", [&service](const Call& call, httplib::Response& response) {
    get_events(service, call, response);
  });
}

}  // namespace rouleau::service
