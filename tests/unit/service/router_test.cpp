#include "service/http/router.h"

#include <gtest/gtest.h>

namespace rouleau::service {
namespace {

using Words = std::vector<std::string>;

Router example() {
  const Handler nothing = [](const Call&, httplib::Response&) {};
  Router router;
  router.add("GET", "/", nothing);
  router.add("GET", "/v1/jobs", nothing);
  router.add("POST", "/v1/jobs", nothing, Body::json);
  router.add("GET", "/v1/jobs/{id}", nothing);
  router.add("POST", "/v1/jobs/{id}:cancel", nothing);
  router.add("GET", "/v1/jobs/{id}/frames/{k}", nothing);
  return router;
}

TEST(Router, FindsTheRouteAndItsParts) {
  const Router router = example();
  auto match = router.find("GET", "/v1/jobs/abc/frames/7");
  ASSERT_NE(match.route, nullptr);
  EXPECT_EQ(match.parts.at("id"), "abc");
  EXPECT_EQ(match.parts.at("k"), "7");

  match = router.find("POST", "/v1/jobs/abc:cancel");
  ASSERT_NE(match.route, nullptr);
  EXPECT_EQ(match.parts.at("id"), "abc");

  EXPECT_NE(router.find("GET", "/").route, nullptr);
  EXPECT_EQ(router.find("POST", "/v1/jobs").route->body, Body::json);
}

TEST(Router, AnswersHeadWhereItAnswersGet) {
  EXPECT_NE(example().find("HEAD", "/v1/jobs").route, nullptr);
  EXPECT_EQ(example().find("HEAD", "/v1/jobs/abc:cancel").route, nullptr);
}

TEST(Router, KnowsWhichMethodsAPathTakes) {
  const auto match = example().find("DELETE", "/v1/jobs");
  EXPECT_EQ(match.route, nullptr);
  EXPECT_EQ(match.allowed, (Words{"GET", "HEAD", "POST"}));
  EXPECT_EQ(example().find("GET", "/v1/jobs/abc:cancel").allowed, (Words{"POST"}));
}

TEST(Router, KnowsNoOtherPath) {
  for (const char* const path : {"/v1", "/v1/", "/v1/jobs/", "/v1/jobs/a/b", "/v1/jobs/a:pause",
                                 "/v1/jobs/:cancel", "//v1/jobs", "/v1/jobs/a/frames/", "/../etc/passwd"}) {
    const auto match = example().find("POST", path);
    EXPECT_EQ(match.route, nullptr) << path;
    EXPECT_TRUE(match.allowed.empty()) << path;
  }
}

}  // namespace
}  // namespace rouleau::service
