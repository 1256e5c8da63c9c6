#include "service/http/problem.h"

#include <set>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rouleau::service {
namespace {

TEST(Problem, IsWhatRfc9457Says) {
  const Problem problem(problems::invalid_case, "two faults",
                        {{"/case/vessel", "is missing"}, {"/case/duration", "must be greater than 0"}});
  const auto json = to_json(problem, "abc");
  EXPECT_EQ(json, nlohmann::json::parse(R"({
    "type": "/problems/invalid-case", "title": "The case cannot be run", "status": 422, "detail": "two faults",
    "request_id": "abc",
    "errors": [{"pointer": "/case/vessel", "message": "is missing"},
               {"pointer": "/case/duration", "message": "must be greater than 0"}]})"));
  EXPECT_FALSE(to_json(Problem(problems::not_found, "x"), "abc").contains("errors"));
}

TEST(ProblemKinds, HaveNamesOfTheirOwnInOrderOfStatus) {
  std::set<std::string_view> names;
  int before = 400;
  for (const ProblemKind* kind : problem_kinds()) {
    EXPECT_TRUE(names.insert(kind->name).second) << kind->name;
    EXPECT_GE(kind->status, before) << kind->name;
    EXPECT_FALSE(kind->title.empty() || kind->meaning.empty()) << kind->name;
    EXPECT_EQ(find_problem_kind(kind->name), kind);
    before = kind->status;
  }
  EXPECT_EQ(find_problem_kind("no-such-problem"), nullptr);
}

TEST(ProblemKinds, StandForABareStatus) {
  EXPECT_EQ(problem_kind_of_status(414).name, "uri-too-long");
  EXPECT_EQ(problem_kind_of_status(418).name, "bad-request");
  EXPECT_EQ(problem_kind_of_status(507).name, "internal");
}

TEST(Dump, ReplacesWhatIsNoUtf8) {
  EXPECT_EQ(dump({{"a", "x\xff"}}), "{\"a\":\"x\xef\xbf\xbd\"}");
}

}  // namespace
}  // namespace rouleau::service
