#include <atomic>
#include <chrono>
#include <string>

#include <gtest/gtest.h>

#include "service/api/service.h"
#include "tests/unit/service/listening.h"
#include "tests/unit/storage/scratch.h"

namespace rouleau::service {
namespace {

using std::chrono::milliseconds;

/// A job that waits, for there is no worker.
class EventsOfAWaitingJob : public testing::Test {
 protected:
  std::string events() {
    Router router;
    add_events(router, service_);
    const Listening server(std::move(router));
    const auto answer = server.client().Get("/v1/jobs/" + id_ + "/events");
    return answer && answer->status == 200 ? answer->body : "no answer";
  }

  storage::ScratchFolder folder_;
  storage::JobStore store_{folder_.path()};
  KnownMachine machine_{folder_.path()};
  Queue queue_{store_, folder_.path(), machine_, std::chrono::seconds(60)};
  std::atomic<bool> draining_ = false;
  Service service_{store_, queue_, draining_, machine_, QueueRoom(store_, 1)};
  std::string id_ = store_.submit(storage::plain_job()).job.id;
};

TEST_F(EventsOfAWaitingJob, EndAfterAWhileThoughTheJobHasNot) {
  service_.streams.longest = milliseconds(300);
  service_.streams.comment_interval = milliseconds(100);
  const std::string text = events();
  EXPECT_NE(text.find("retry: 2000\n\nid: 0@"), std::string::npos) << text;
  EXPECT_NE(text.find("\nevent: state\ndata: {"), std::string::npos) << text;
  EXPECT_EQ(text.find("event: state"), text.rfind("event: state")) << "told twice";
  EXPECT_NE(text.find("\n: still here\n\n"), std::string::npos) << text;
  EXPECT_EQ(service_.streams.open, 0);
}

TEST_F(EventsOfAWaitingJob, EndWhileTheServerDrains) {
  draining_ = true;
  EXPECT_EQ(events(), "");
}

TEST_F(EventsOfAWaitingJob, AreForAsManyAsThereMayBe) {
  service_.streams.most = 0;
  EXPECT_EQ(events(), "no answer");
  EXPECT_EQ(service_.streams.open, 0);
}

}  // namespace
}  // namespace rouleau::service
