#pragma once

#include <cstddef>
#include <string>

#include <httplib.h>

#include "service/http/access.h"
#include "service/http/connection.h"
#include "service/http/problem.h"
#include "service/http/router.h"

namespace rouleau::service {

struct ServerSettings {
  std::size_t threads = 64;
  RequestLimits limits;
  ConnectionTimeouts timeouts;
  Access access;
};

/// cpp-httplib's server behind our own reading of connections and our own routes. It answers only what the
/// router knows, and every error as a problem.
class GuardedServer : private httplib::Server {
 public:
  GuardedServer(Router router, ServerSettings settings);

  /// Takes the address, without sharing it with another process.
  /// @param port 0: any that is free
  /// @return the port taken
  /// @throws std::runtime_error if the address is in use or cannot be had
  int listen_on(const std::string& host, int port);

  /// Answers until `stop`. Connections that are being served end first.
  void serve() { listen_after_bind(); }

  /// From any thread, also before `serve` or twice.
  void stop();

 private:
  bool process_and_close_socket(socket_t socket) override;
  bool answer_one(Connection& connection);
  bool admit(const httplib::Request& request, httplib::Response& response) const;
  void dispatch(const httplib::Request& request, httplib::Response& response) const;
  Router::Match route(const httplib::Request& request) const;

  Router router_;
  ServerSettings settings_;
};

/// Writes a problem as the answer.
void answer(const Problem& problem, const std::string& request_id, httplib::Response& response);

/// Writes JSON as the answer.
void answer_json(const nlohmann::json& value, httplib::Response& response, int status = 200);

}  // namespace rouleau::service
