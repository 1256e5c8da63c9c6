#include "service/http/waiting_room.h"

#include <arpa/inet.h>
#include <array>
#include <atomic>
#include <chrono>
#include <deque>
#include <gmock/gmock.h>
#include <memory>
#include <netinet/in.h>
#include <poll.h>
#include <string>
#include <sys/socket.h>
#include <thread>

#include <gtest/gtest.h>

#include "tests/unit/service/listening.h"

namespace rouleau::service {
namespace {

using std::chrono::milliseconds;

/// A client that sends and reads what it likes, when it likes.
class RawClient {
 public:
  explicit RawClient(int port, int receive_buffer = 0) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    if (receive_buffer > 0)
      ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof(receive_buffer));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof(address)), 0);
  }
  ~RawClient() { ::close(socket_); }
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;

  void send(const std::string& text) const {
    EXPECT_EQ(::send(socket_, text.data(), text.size(), MSG_NOSIGNAL), static_cast<ssize_t>(text.size()));
  }

  /// What comes until `end` is in it, or until the server closes.
  std::string read_to(const std::string& end) const {
    std::string text;
    while (end.empty() || text.find(end) == std::string::npos) {
      std::array<char, 65536> buffer;
      const ssize_t count = ::recv(socket_, buffer.data(), buffer.size(), 0);
      if (count <= 0) break;
      text.append(buffer.data(), static_cast<std::size_t>(count));
    }
    return text;
  }
  std::string read_all() const { return read_to(""); }

  bool is_told_something(milliseconds patience) const {
    pollfd entry{socket_, POLLIN, 0};
    return ::poll(&entry, 1, static_cast<int>(patience.count())) > 0;
  }

 private:
  int socket_;
};

constexpr const char* request = "GET /hello HTTP/1.1\r\nHost: localhost\r\n\r\n";
constexpr std::size_t long_length = 32 << 20;

Router example(std::atomic<int>* pieces = nullptr) {
  Router router;
  router.add("GET", "/hello", [](const Call&, httplib::Response& response) {
    response.set_content("good day", "text/plain");
  });
  router.add(
      "POST", "/length",
      [](const Call& call, httplib::Response& response) {
        response.set_content("got " + std::to_string(call.request.body.size()), "text/plain");
      },
      Body::json);
  router.add("GET", "/long", [pieces](const Call&, httplib::Response& response) {
    response.set_content_provider(long_length, "text/plain",
                                  [pieces](std::size_t, std::size_t left, httplib::DataSink& sink) {
                                    if (pieces != nullptr) ++*pieces;
                                    const std::string piece(std::min<std::size_t>(left, 65536), 'x');
                                    return sink.write(piece.data(), piece.size());
                                  });
  });
  return router;
}

ServerSettings with_one_thread() {
  ServerSettings settings;
  settings.threads = 1;
  return settings;
}

TEST(WaitingRoom, HasNoThreadWaitForWhoSendsSlowly) {
  const Listening server(example(), with_one_thread());
  const RawClient silent(server.port());
  const RawClient in_the_head(server.port());
  in_the_head.send("GET /hello HTTP/1.1\r\nHo");
  const RawClient in_the_body(server.port());
  in_the_body.send(
      "POST /length HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"
      "Content-Length: 4\r\n\r\n12");
  EXPECT_EQ(server.client().Get("/hello")->body, "good day");
  in_the_head.send("st: localhost\r\n\r\n");
  EXPECT_NE(in_the_head.read_to("good day").find(" 200 OK"), std::string::npos);
  in_the_body.send("34");
  EXPECT_NE(in_the_body.read_to("got 4").find(" 200 OK"), std::string::npos);
}

TEST(WaitingRoom, HasNoThreadWaitForWhoReadsSlowly) {
  std::atomic<int> pieces = 0;
  const Listening server(example(&pieces), with_one_thread());
  const RawClient slow(server.port(), 4096);
  slow.send("GET /long HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
  ASSERT_TRUE(slow.is_told_something(milliseconds(5000)));
  EXPECT_EQ(server.client().Get("/hello")->body, "good day");
  // Nor is the answer made for which nobody is ready.
  EXPECT_LT(pieces, static_cast<int>(long_length / 65536));
  const std::string answer = slow.read_all();
  EXPECT_EQ(answer.size() - answer.find("\r\n\r\n") - 4, long_length);
}

TEST(WaitingRoom, GivesUpWhoIsTooSlow) {
  ServerSettings settings;
  settings.timeouts.idle = settings.timeouts.head = settings.timeouts.body = milliseconds(300);
  const Listening server(example(), settings);
  const RawClient silent(server.port());
  EXPECT_EQ(silent.read_all(), "");
  const RawClient in_the_head(server.port());
  in_the_head.send("GET /hello HTTP/1.1\r\nHo");
  EXPECT_TRUE(in_the_head.read_all().starts_with("HTTP/1.1 408 "));
  const RawClient in_the_body(server.port());
  in_the_body.send(
      "POST /length HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"
      "Content-Length: 4\r\n\r\n12");
  EXPECT_TRUE(in_the_body.read_all().starts_with("HTTP/1.1 408 "));
}

TEST(WaitingRoom, GivesUpWhoDoesNotTakeItsAnswer) {
  ServerSettings settings;
  settings.timeouts.answer = milliseconds(300);
  settings.timeouts.least_bytes_per_second = 1 << 30;
  const Listening server(example(), settings);
  const RawClient slow(server.port(), 4096);
  slow.send("GET /long HTTP/1.1\r\nHost: localhost\r\n\r\n");
  const auto begun = std::chrono::steady_clock::now();
  while (server.server().connections() == 0) std::this_thread::sleep_for(milliseconds(10));
  while (server.server().connections() > 0) {
    ASSERT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(30));
    std::this_thread::sleep_for(milliseconds(10));
  }
  EXPECT_LT(slow.read_all().size(), long_length);
}

TEST(WaitingRoom, TurnsAwayWhoIsTooMany) {
  ServerSettings settings;
  settings.room.connections = 2;
  const Listening server(example(), settings);
  std::deque<RawClient> inside;
  for (int i = 0; i < 2; ++i) {
    inside.emplace_back(server.port()).send(request);
    EXPECT_TRUE(inside.back().read_to("good day").starts_with("HTTP/1.1 200 "));
  }
  const std::string answer = RawClient(server.port()).read_all();
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 503 "));
  EXPECT_NE(answer.find("Retry-After"), std::string::npos);
  EXPECT_NE(answer.find("/problems/too-many-connections"), std::string::npos);
  inside.pop_back();
  for (std::string text; !text.starts_with("HTTP/1.1 200 ");) {
    const RawClient next(server.port());
    next.send(request);
    text = next.read_to("\r\n\r\n");
  }
}

TEST(WaitingRoom, TurnsAwayAnAddressThatHasTooMany) {
  ServerSettings settings;
  settings.room.connections_of_an_address = 1;
  const Listening server(example(), settings);
  const RawClient first(server.port());
  first.send(request);
  EXPECT_TRUE(first.read_to("good day").starts_with("HTTP/1.1 200 "));
  EXPECT_TRUE(RawClient(server.port()).read_all().starts_with("HTTP/1.1 503 "));
}

TEST(WaitingRoom, KeepsNoMoreThanItMay) {
  ServerSettings settings;
  settings.room.held_bytes = 300000;
  const Listening server(example(), settings);
  const RawClient sends_much(server.port());
  sends_much.send(
      "POST /length HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"
      "Content-Length: 1000000\r\n\r\n" +
      std::string(500000, ' '));
  EXPECT_EQ(sends_much.read_all(), "");
  EXPECT_EQ(server.client().Get("/hello")->body, "good day");
}

TEST(WaitingRoom, HoldsNoMoreRequestsThatWaitForAThread) {
  std::atomic<bool> may_answer = false;
  Router router = example();
  router.add("GET", "/later", [&](const Call&, httplib::Response& response) {
    may_answer.wait(false);
    response.set_content("late", "text/plain");
  });
  ServerSettings settings = with_one_thread();
  settings.room.held_bytes = 300000;
  const Listening server(std::move(router), settings);
  const RawClient takes_the_thread(server.port());
  takes_the_thread.send("GET /later HTTP/1.1\r\nHost: localhost\r\n\r\n");
  const std::string long_request =
      "POST /length HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"
      "Content-Length: 100000\r\n\r\n" +
      std::string(100000, ' ');
  std::deque<RawClient> clients;
  for (int k = 0; k < 4; ++k) clients.emplace_back(server.port()).send(long_request);
  std::deque<bool> refused;
  for (const RawClient& client : clients) refused.push_back(client.is_told_something(milliseconds(500)));
  may_answer = true;
  may_answer.notify_all();
  for (std::size_t k = 0; k < clients.size(); ++k) {
    EXPECT_NE(clients[k].read_to("\r\n").find(refused[k] ? " 503 " : " 200 "), std::string::npos);
  }
  EXPECT_THAT(refused, testing::AllOf(testing::Contains(true), testing::Contains(false)));
}

TEST(WaitingRoom, SaysToGoOnBeforeTheBodyOnlyToWhomItIsWelcome) {
  const Listening server(example());
  const RawClient welcome(server.port());
  const std::string head =
      "Host: localhost\r\nContent-Type: application/json\r\nExpect: 100-continue\r\nContent-Length: "
      "2\r\n\r\n";
  welcome.send("POST /length HTTP/1.1\r\n" + head);
  EXPECT_EQ(welcome.read_to("\r\n\r\n"), "HTTP/1.1 100 Continue\r\n\r\n");
  welcome.send("{}");
  EXPECT_TRUE(welcome.read_to("got 2").starts_with("HTTP/1.1 200 "));
  const RawClient unwelcome(server.port());
  unwelcome.send("POST /nowhere HTTP/1.1\r\n" + head);
  EXPECT_TRUE(unwelcome.read_all().starts_with("HTTP/1.1 404 "));
}

TEST(WaitingRoom, StopsAtOnceWhoeverWaits) {
  auto server = std::make_unique<const Listening>(example());
  const RawClient waiting(server->port());
  waiting.send("GET /hel");
  EXPECT_EQ(server->client().Get("/hello")->status, 200);
  server.reset();
  EXPECT_EQ(waiting.read_all(), "");
}

}  // namespace
}  // namespace rouleau::service
