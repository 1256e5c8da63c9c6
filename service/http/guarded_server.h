#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include <httplib.h>

#include "service/http/access.h"
#include "service/http/connection.h"
#include "service/http/gate.h"
#include "service/http/problem.h"
#include "service/http/router.h"
#include "service/http/waiting_room.h"

namespace rouleau::service {

/// What is told of each request once it is answered.
struct Answered {
  std::string method;  ///< of the route; "" where there is none
  std::string route;   ///< its pattern
  int status = 0;
  double seconds = 0;  ///< since its head was there
};

struct ServerSettings {
  /// Half of them for requests that wait, which hold one each; streams come on top.
  std::size_t threads = 64;
  RequestLimits limits;
  ConnectionTimeouts timeouts;
  RoomLimits room;
  std::shared_ptr<const Access> access = std::make_shared<Access>();
  RateLimit rate;
  std::function<void(const Answered&)> on_answer = [](const Answered&) {};
};

/// cpp-httplib's reading of requests and writing of answers behind our own connections and our own routes.
/// It answers only what the router knows, and every error as a problem. A thread is taken only by a request
/// that is whole; the waiting room has all others.
class GuardedServer : private httplib::Server, private Reception {
 public:
  GuardedServer(Router router, ServerSettings settings);
  ~GuardedServer() override;

  /// Takes the address, without sharing it with another process.
  /// @param port 0: any that is free
  /// @return the port taken
  /// @throws std::runtime_error if the address is in use or cannot be had
  int listen_on(const std::string& host, int port);

  /// Answers until `stop`. What is being answered ends first.
  void serve();

  /// From any thread, also before `serve` or twice.
  void stop();

  std::size_t connections() const { return room_.connections(); }

 private:
  void admit(Connection& connection) override;
  std::string refusal(const Connection& connection, const Problem& problem) override;
  void serve(std::unique_ptr<Connection> connection) override;
  bool answer(Connection& connection);

  Router router_;
  const ServerSettings settings_;
  Gate gate_;
  WaitingRoom room_;
  std::unique_ptr<httplib::ThreadPool> pool_;
  int listener_ = INVALID_SOCKET;
};

/// Writes a problem as the answer.
void answer(const Problem& problem, const std::string& request_id, httplib::Response& response);

/// Writes JSON as the answer.
void answer_json(const nlohmann::json& value, httplib::Response& response, int status = 200);
/// The same of what is JSON already.
void answer_json_text(std::string text, httplib::Response& response, int status = 200);

}  // namespace rouleau::service
