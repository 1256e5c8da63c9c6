#pragma once

#include <thread>
#include <utility>

#include "service/http/guarded_server.h"

namespace rouleau::service {

/// A server on a port of its own, for as long as a test lasts.
class Listening {
 public:
  explicit Listening(Router router, ServerSettings settings = {})
      : server_(std::move(router), std::move(settings)), port_(server_.listen_on("127.0.0.1", 0)) {
    thread_ = std::thread([this] { server_.serve(); });
  }
  ~Listening() {
    server_.stop();
    thread_.join();
  }
  int port() const { return port_; }
  httplib::Client client() const { return httplib::Client("127.0.0.1", port_); }
  const GuardedServer& server() const { return server_; }

 private:
  GuardedServer server_;
  int port_;
  std::thread thread_;
};

}  // namespace rouleau::service
