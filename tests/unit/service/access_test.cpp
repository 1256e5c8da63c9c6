#include "service/http/access.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "service/http/problem.h"

namespace rouleau::service {
namespace {

TEST(Access, KnowsTheNamesOfTheLoopback) {
  const Access access;
  for (const char* const host :
       {"localhost", "localhost:8080", "127.0.0.1:1", "[::1]", "[::1]:8080", "LOCALHOST:1"}) {
    EXPECT_NO_THROW(access.check_host(host)) << host;
  }
  for (const char* const host :
       {"evil.example", "localhost.evil.example:8080", "127.0.0.1.evil.example", "", "[::1", "[::2]:80"}) {
    EXPECT_THROW(access.check_host(host), Problem) << host;
  }
}

TEST(Access, WithTokensAnyNameWillDo) {
  EXPECT_NO_THROW(Access({"0123456789abcdef"}).check_host("rouleau.example"));
}

TEST(Access, RefusesPagesOfOtherSites) {
  EXPECT_NO_THROW(Access::check_origin("", "localhost:8080"));
  EXPECT_NO_THROW(Access::check_origin("http://localhost:8080", "localhost:8080"));
  EXPECT_NO_THROW(Access::check_origin("https://Rouleau.example", "rouleau.example"));
  for (const char* const origin :
       {"http://evil.example", "http://localhost:9090", "null", "http://localhost:8080.evil.example"}) {
    EXPECT_THROW(Access::check_origin(origin, "localhost:8080"), Problem) << origin;
  }
}

TEST(Access, TakesItsTokensAlone) {
  const Access access({"0123456789abcdef", "another-token-of-mine"});
  EXPECT_NO_THROW(access.check_token("Bearer another-token-of-mine"));
  EXPECT_NO_THROW(access.check_token("bearer 0123456789abcdef"));
  for (const char* const header :
       {"", "Bearer", "Bearer ", "Bearer 0123456789abcde", "Bearer 0123456789abcdeg",
        "Bearer 0123456789abcdef0", "Basic 0123456789abcdef", "0123456789abcdef"}) {
    EXPECT_THROW(access.check_token(header), Problem) << header;
  }
  EXPECT_NO_THROW(Access().check_token(""));
}

TEST(TokenFile, HoldsOneTokenALine) {
  const auto file = std::filesystem::path(testing::TempDir()) / "tokens_test";
  std::ofstream(file) << "# ours\n0123456789abcdef\r\n\nfedcba9876543210  \n";
  EXPECT_EQ(read_tokens(file), (std::vector<std::string>{"0123456789abcdef", "fedcba9876543210"}));
  std::ofstream(file) << "# none\n\n";
  EXPECT_THROW(read_tokens(file), std::runtime_error);
  std::ofstream(file) << "short\n";
  EXPECT_THROW(read_tokens(file), std::runtime_error);
  std::filesystem::remove(file);
  EXPECT_THROW(read_tokens(file), std::runtime_error);
}

TEST(Loopback, IsThisMachineAlone) {
  for (const char* const address : {"127.0.0.1", "127.1.2.3", "::1", "localhost"})
    EXPECT_TRUE(is_loopback(address)) << address;
  for (const char* const address : {"0.0.0.0", "::", "192.168.0.1", ""}) {
    EXPECT_FALSE(is_loopback(address)) << address;
  }
}

}  // namespace
}  // namespace rouleau::service
