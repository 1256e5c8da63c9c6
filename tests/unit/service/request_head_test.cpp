#include "service/http/request_head.h"

#include <string>

#include <gtest/gtest.h>

#include "service/http/problem.h"

namespace rouleau::service {
namespace {

std::string head(const std::string& line, const std::string& headers) {
  return line + "\r\nHost: localhost\r\n" + headers + "\r\n";
}

int status_of(const std::string& text, const RequestLimits& limits = {}) {
  try {
    read_request_head(text, limits);
    return 0;
  } catch (const Problem& problem) {
    return problem.kind().status;
  }
}

TEST(RequestHead, ReadsLineAndHeaders) {
  const RequestHead read =
      read_request_head(head("POST /v1/jobs?x=1 HTTP/1.1", "content-length:  12 \r\nX-Other: a: b\r\n"), {});
  EXPECT_EQ(read.method, "POST");
  EXPECT_EQ(read.target, "/v1/jobs?x=1");
  EXPECT_EQ(read.content_length, 12u);
  EXPECT_EQ(read.header("x-OTHER"), "a: b");
  EXPECT_EQ(read.header("absent"), "");
}

TEST(RequestHead, RefusesBodiesOfUnknownLength) {
  EXPECT_EQ(status_of(head("POST / HTTP/1.1", "Transfer-Encoding: chunked\r\n")), 411);
  EXPECT_EQ(status_of(head("POST / HTTP/1.1", "Transfer-Encoding: chunked\r\nContent-Length: 3\r\n")), 411);
  EXPECT_EQ(status_of(head("GET / HTTP/1.1", "transfer-encoding: identity\r\n")), 411);
}

TEST(RequestHead, RefusesLengthsThatCanBeReadInTwoWays) {
  for (const char* const value : {"", "x", "-1", "+5", "0x10", "5 5", "5,5", "1.0", "%35"}) {
    EXPECT_EQ(status_of(head("POST / HTTP/1.1", "Content-Length: " + std::string(value) + "\r\n")), 400)
        << value;
  }
  EXPECT_EQ(status_of(head("POST / HTTP/1.1", "Content-Length: 5\r\nContent-Length: 5\r\n")), 400);
}

TEST(RequestHead, RefusesWhatIsTooLarge) {
  RequestLimits limits;
  limits.body_bytes = 100;
  limits.headers = 3;
  limits.target_bytes = 20;
  EXPECT_EQ(status_of(head("POST / HTTP/1.1", "Content-Length: 100\r\n"), limits), 0);
  EXPECT_EQ(status_of(head("POST / HTTP/1.1", "Content-Length: 101\r\n"), limits), 413);
  EXPECT_EQ(status_of(head("POST / HTTP/1.1", "Content-Length: 99999999999999999999999\r\n"), limits), 413);
  EXPECT_EQ(status_of(head("GET / HTTP/1.1", "A: 1\r\nB: 2\r\n"), limits), 0);
  EXPECT_EQ(status_of(head("GET / HTTP/1.1", "A: 1\r\nB: 2\r\nC: 3\r\n"), limits), 431);
  EXPECT_EQ(status_of(head("GET /" + std::string(20, 'a') + " HTTP/1.1", ""), limits), 414);
}

TEST(RequestHead, RefusesAHeaderThatIsTooLong) {
  EXPECT_EQ(status_of(head("GET / HTTP/1.1", "Cookie: " + std::string(7000, 'x') + "\r\n")), 0);
  EXPECT_EQ(status_of(head("GET / HTTP/1.1", "Cookie: " + std::string(9000, 'x') + "\r\n")), 431);
}

TEST(RequestHead, RefusesCompressedBodies) {
  EXPECT_EQ(status_of(head("POST / HTTP/1.1", "Content-Length: 5\r\nContent-Encoding: gzip\r\n")), 415);
  EXPECT_EQ(status_of(head("POST / HTTP/1.1", "Content-Length: 5\r\nContent-Encoding: identity\r\n")), 0);
}

TEST(RequestHead, RefusesWhatIsNotHttp) {
  EXPECT_EQ(status_of(head("GET / HTTP/1.1", "A: 1\r\n\r\nB: 2\r\n")), 400);
  EXPECT_EQ(status_of("GET /\r\nHost: a\r\n\r\n"), 400);
  EXPECT_EQ(status_of("GET / HTTP/2\r\nHost: a\r\n\r\n"), 400);
  EXPECT_EQ(status_of("GET  / HTTP/1.1\r\nHost: a\r\n\r\n"), 400);
  EXPECT_EQ(status_of("GET / HTTP/1.1\r\n\r\n"), 400) << "no Host";
  EXPECT_EQ(status_of(head("GET / HTTP/1.1", "Host: other\r\n")), 400) << "two hosts";
  EXPECT_EQ(status_of(head("GET / HTTP/1.1", "A: 1\n B: 2\r\n")), 400) << "bare line feed";
  EXPECT_EQ(status_of(head("GET / HTTP/1.1", " folded\r\n")), 400);
  EXPECT_EQ(status_of(head("GET / HTTP/1.1", "Content-Length : 5\r\n")), 400) << "space before the colon";
  EXPECT_EQ(status_of(head("GET / HTTP/1.1", "Content-Length: 5\r\n")), 400) << "a GET with a body";
  EXPECT_EQ(status_of(head("GET / HTTP/1.1", std::string("A: 1\0 2\r\n", 9))), 400) << "NUL";
}

TEST(HeadForHttplib, HidesRangesAndSaysHowLongABodyIs) {
  RequestHead read =
      read_request_head(head("GET /a HTTP/1.1", "Range: bytes=0-99999\r\nAccept-Encoding: gzip, br\r\n"), {});
  EXPECT_EQ(head_for_httplib(read), "GET /a HTTP/1.1\r\nHost: localhost\r\n\r\n");
  read = read_request_head(head("POST /a HTTP/1.1", ""), {});
  EXPECT_EQ(head_for_httplib(read), "POST /a HTTP/1.1\r\nHost: localhost\r\nContent-Length: 0\r\n\r\n");
}

TEST(RequestHead, TakesOnlyTargetsOfThisServer) {
  for (const char* target : {"v1/jobs", "*", "http://localhost/v1/jobs", "?/v1"}) {
    EXPECT_EQ(status_of(head("GET " + std::string(target) + " HTTP/1.1", "")), 400) << target;
  }
}

TEST(Query, IsWhatTheTargetAsksDecodedOnce) {
  using Parameters = std::multimap<std::string, std::string>;
  EXPECT_EQ(query_of("/a?label=k:a=b&state=queued&state=failed#c?d=e"),
            (Parameters{{"label", "k:a=b"}, {"state", "queued"}, {"state", "failed"}}));
  EXPECT_EQ(query_of("/a?x=1+2%2B3%253&&%79"), (Parameters{{"x", "1 2+3%3"}, {"y", ""}}));
  EXPECT_TRUE(query_of("/a").empty());
  EXPECT_TRUE(query_of("/a?").empty());
}

TEST(Path, IsWhatTheTargetNamesDecodedOnce) {
  EXPECT_EQ(path_of("/v1/jobs?state=queued"), "/v1/jobs");
  EXPECT_EQ(path_of("/a#b?c"), "/a");
  EXPECT_EQ(path_of("/%76%31/%2e%2E/%252e"), "/v1/../%2e");
  EXPECT_EQ(path_of("/%"), "/%");
  EXPECT_EQ(path_of("/%4"), "/%4");
  EXPECT_EQ(path_of("/%zz%+1%-1"), "/%zz%+1%-1");
  EXPECT_EQ(path_of("/a+b"), "/a+b");
}

}  // namespace
}  // namespace rouleau::service
