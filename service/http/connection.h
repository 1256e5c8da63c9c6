#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include <httplib.h>

#include "service/http/request_head.h"

namespace rouleau::service {

struct ConnectionTimeouts {
  std::chrono::milliseconds idle{1000};     ///< between two requests
  std::chrono::milliseconds head{5000};     ///< for a whole head, however slowly it drips
  std::chrono::milliseconds body{10000};    ///< for a whole body
  std::chrono::milliseconds silence{5000};  ///< without a byte, in either direction
};

/// One accepted connection: hands cpp-httplib one checked request at a time and counts what it reads of the
/// body, so that what is left unread can never be taken for the next request. Owns the socket.
class Connection : public httplib::Stream {
 public:
  Connection(socket_t socket, const RequestLimits& limits, const ConnectionTimeouts& timeouts);
  ~Connection() override;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Waits for the first byte of a request; false if none comes in time, the peer leaves or `stopping` says
  /// so.
  bool wait_for_request(const std::function<bool()>& stopping);

  /// Reads the next head and makes ready to be read by cpp-httplib.
  /// @throws Problem if it is refused
  RequestHead next_request();

  bool body_is_read() const { return body_left_ == 0; }

  /// Ends our side and takes in what the peer still sends, so that it gets to read our last answer.
  void close_gently();

  bool is_readable() const override;
  bool is_writable() const override;
  ssize_t read(char* data, size_t size) override;
  ssize_t write(const char* data, size_t size) override;
  void get_remote_ip_and_port(std::string& ip, int& port) const override;
  void get_local_ip_and_port(std::string& ip, int& port) const override;
  socket_t socket() const override { return socket_; }

 private:
  using Clock = std::chrono::steady_clock;

  bool wait_until(short events, Clock::time_point deadline) const;
  bool receive(Clock::time_point deadline);
  std::string_view take_head();

  socket_t socket_;
  RequestLimits limits_;
  ConnectionTimeouts timeouts_;
  std::string received_;  ///< from the socket, not yet taken
  std::string head_;      ///< what cpp-httplib reads first
  std::size_t head_read_ = 0;
  std::size_t body_left_ = 0;  ///< of the request's body, not yet read by cpp-httplib
  Clock::time_point body_deadline_;
};

}  // namespace rouleau::service
