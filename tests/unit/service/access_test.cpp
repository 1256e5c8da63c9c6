#include "service/http/access.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "service/http/problem.h"
#include "storage/sha256.h"

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

std::string hash(const std::string& token) {
  return storage::sha256_hex(token);
}

TEST(Access, WithTokensAnyNameWillDo) {
  EXPECT_NO_THROW(Access({{"a", Scope::read, hash("x")}}).check_host("rouleau.example"));
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

TEST(Access, KnowsItsTokensAlone) {
  const Access access(
      {{"reader", Scope::read, hash("0123456789abcdef")}, {"lab", Scope::admin, hash("another")}});
  const auto caller = access.identify("Bearer another");
  ASSERT_TRUE(caller);
  EXPECT_EQ(caller->name, "lab");
  EXPECT_EQ(caller->scope, Scope::admin);
  EXPECT_EQ(access.identify("bearer 0123456789abcdef")->scope, Scope::read);
  for (const char* const header :
       {"", "Bearer", "Bearer ", "Bearer 0123456789abcde", "Bearer 0123456789abcdeg",
        "Bearer 0123456789abcdef0", "Basic 0123456789abcdef", "0123456789abcdef"}) {
    EXPECT_FALSE(access.identify(header)) << header;
  }
  EXPECT_FALSE(access.identify("Bearer " + hash("another"))) << "what is in the file opens nothing";
  EXPECT_EQ(Access().identify("")->scope, Scope::admin);
}

TEST(Access, HasItsTokensReplaced) {
  Access access({{"a", Scope::read, hash("first")}});
  access.replace_tokens({{"b", Scope::submit, hash("second")}});
  EXPECT_FALSE(access.identify("Bearer first"));
  EXPECT_EQ(access.identify("Bearer second")->name, "b");
}

TEST(Scopes, EachIncludeThoseBefore) {
  EXPECT_EQ(parse_scopes("read"), Scope::read);
  EXPECT_EQ(parse_scopes("read,submit"), Scope::submit);
  EXPECT_EQ(parse_scopes("admin,read"), Scope::admin);
  for (const char* const text : {"", ",", "read,", "write", "read submit", "Read"}) {
    EXPECT_FALSE(parse_scopes(text)) << text;
  }
  EXPECT_LT(Scope::read, Scope::submit);
  EXPECT_LT(Scope::submit, Scope::admin);
}

TEST(TokenFile, HoldsNamesScopesAndHashes) {
  const auto tokens =
      parse_tokens("# ours\nbench read,submit " + hash("a") + "\r\n\n  lab.1\tadmin  " + hash("b") + " \n");
  ASSERT_EQ(tokens.size(), 2u);
  EXPECT_EQ(tokens[0].name, "bench");
  EXPECT_EQ(tokens[0].scope, Scope::submit);
  EXPECT_EQ(tokens[1].sha256, hash("b"));
}

TEST(TokenFile, IsReadWholeOrNotAtAll) {
  try {
    parse_tokens("0123456789abcdef\nok read " + hash("a") + "\nbad/name read " + hash("a") + "\nx write " +
                 hash("a") + "\nx read 0123\nx read\n");
    FAIL() << "taken";
  } catch (const std::runtime_error& error) {
    const std::string text = error.what();
    for (const char* const part :
         {"line 1: ", "line 3: ", "line 4: ", "line 5: ", "line 6: ", "rouleau token"})
      EXPECT_NE(text.find(part), std::string::npos) << part;
    EXPECT_EQ(text.find("line 2: "), std::string::npos);
    EXPECT_EQ(text.find("0123456789abcdef"), std::string::npos) << "a token is shown";
  }
  const auto file = std::filesystem::path(testing::TempDir()) / "tokens_test";
  std::ofstream(file) << "# none\n\n";
  EXPECT_THROW(read_tokens(file), std::runtime_error);
  std::filesystem::remove(file);
  EXPECT_THROW(read_tokens(file), std::runtime_error);
}

TEST(TokenFile, TakesTheLineOfANewToken) {
  const std::string token = new_token();
  EXPECT_NE(token, new_token());
  EXPECT_GE(token.size(), 64u);
  const Access access(parse_tokens(token_line("me", Scope::submit, token)));
  EXPECT_EQ(access.identify("Bearer " + token)->name, "me");
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
