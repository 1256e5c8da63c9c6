#include "service/http/guarded_server.h"

#include <atomic>
#include <filesystem>
#include <stdexcept>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "service/api/service.h"
#include "tests/unit/service/listening.h"

namespace rouleau::service {
namespace {

TEST(GuardedServer, TellsNothingOfAnUnexpectedException) {
  Router router;
  router.add("GET", "/fails",
             [](const Call&, httplib::Response&) { throw std::runtime_error("the password is 1234"); });
  const Listening server(std::move(router));
  const auto answer = server.client().Get("/fails");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 500);
  const auto problem = nlohmann::json::parse(answer->body);
  EXPECT_EQ(problem["type"], "/problems/internal");
  EXPECT_EQ(problem["request_id"], answer->get_header_value("X-Request-Id"));
  EXPECT_EQ(answer->body.find("1234"), std::string::npos);
  EXPECT_FALSE(answer->has_header("EXCEPTION_WHAT"));
}

TEST(GuardedServer, SharesItsPortWithNobody) {
  const Listening server{Router{}};
  GuardedServer second(Router{}, {});
  EXPECT_THROW(second.listen_on("127.0.0.1", server.port()), std::runtime_error);
}

TEST(Health, IsNotReadyWhileDraining) {
  std::atomic<bool> draining = false;
  Router router;
  add_health(router, draining);
  const Listening server(std::move(router));
  auto client = server.client();
  EXPECT_EQ(client.Get("/readyz")->status, 200);
  draining = true;
  EXPECT_EQ(client.Get("/readyz")->status, 503);
  EXPECT_EQ(client.Get("/livez")->status, 200);
}

TEST(Jobs, AreNotTakenWhileDraining) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "jobs_while_draining_test";
  std::filesystem::remove_all(folder);
  {
    storage::JobStore store(folder);
    KnownMachine machine(folder);
    Queue queue(store, folder, machine, std::chrono::seconds(60));
    std::atomic<bool> draining = true;
    Service service{store, queue, draining, machine, QueueRoom(store, 1)};
    Router router;
    add_jobs(router, service);
    const Listening server(std::move(router));
    const auto answer = server.client().Post("/v1/jobs", "{}", "application/json");
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->status, 503);
    EXPECT_EQ(nlohmann::json::parse(answer->body)["type"], "/problems/draining");
    EXPECT_TRUE(answer->has_header("Retry-After"));
    EXPECT_TRUE(store.list({}).jobs.empty());
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace rouleau::service
