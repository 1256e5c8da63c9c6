#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <httplib.h>

#include "service/http/admission.h"
#include "service/http/request_head.h"

namespace rouleau::service {

struct ConnectionTimeouts {
  std::chrono::milliseconds idle{15000};       ///< between two requests
  std::chrono::milliseconds head{5000};        ///< for a whole head, however slowly it drips
  std::chrono::milliseconds body{10000};       ///< for a whole body
  std::chrono::milliseconds answer{10000};     ///< for an answer to be taken, and more for a long one:
  std::size_t least_bytes_per_second = 16384;  ///< at what rate it is taken at the least
  std::chrono::milliseconds silence{5000};     ///< in which a stream's reader takes nothing
  std::chrono::milliseconds unheard{10000};    ///< since a stream's reader confirmed what was sent
  std::chrono::milliseconds goodbye{500};      ///< for the peer to close, once we have
};

/// A request and what belongs to it, from its head until its answer is made.
struct Exchange {
  RequestHead head;
  std::string id;
  std::chrono::steady_clock::time_point begun;
  Admission admission;
};

/// One accepted connection: takes in requests and sends answers without ever waiting for the peer, and hands
/// cpp-httplib one checked request at a time. Only a stream (an answer without a length) waits, and briefly.
/// Owns the socket.
class Connection : public httplib::Stream {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param socket that does not block
  Connection(socket_t socket, std::string address, const RequestLimits& limits,
             const ConnectionTimeouts& timeouts);
  ~Connection() override;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  int descriptor() const { return socket_; }
  const std::string& address() const { return address_; }

  /// Takes in some of what has arrived.
  void receive();
  /// The peer will send no more.
  bool has_ended() const { return ended_; }
  bool has_received() const { return !received_.empty(); }

  /// Begins an exchange if a whole head is there.
  /// @return whether an exchange has begun
  /// @throws Problem if the head is refused
  bool begin_exchange();
  Exchange* exchange() { return exchange_ ? &*exchange_ : nullptr; }
  /// The body is here, too.
  bool request_is_whole() const;
  /// Forgets the request. What is left of its body ends the connection, since it is no next request.
  void end_exchange();

  /// To be ended once its answer is sent.
  void end_after_answer() { ending_ = true; }
  bool is_ending() const { return ending_; }
  /// Ends our side; the peer still gets to read what was sent.
  void end();
  /// Throws away what the peer still sends.
  /// @return false once there is no more to come, or it was too much
  bool discard();

  /// The body that follows what is written: asked for, a piece at a time, as the peer takes it.
  void attach(httplib::ContentProvider provider, std::size_t length);
  /// From here on each piece is sent as it is written.
  void begin_stream();
  bool has_output() const { return sent_ < output_.size() || body_left_ > 0; }
  /// Sends what the peer takes now.
  /// @return false if it can be sent no more
  bool flush();
  /// By when an answer that did not go out at once must have been taken.
  Clock::time_point answer_deadline() const { return answer_deadline_.value_or(Clock::now()); }
  /// What it keeps in memory.
  std::size_t held_bytes() const { return received_.capacity() + output_.capacity(); }

  bool is_readable() const override { return true; }
  bool is_writable() const override;
  ssize_t read(char* data, size_t size) override;
  ssize_t write(const char* data, size_t size) override;
  void get_remote_ip_and_port(std::string& ip, int& port) const override;
  void get_local_ip_and_port(std::string&, int&) const override {}
  /// cpp-httplib asks for it to refuse numbers that select() could not take, which nobody calls here.
  socket_t socket() const override { return INVALID_SOCKET; }

 private:
  bool send_output();
  bool fetch_body();
  bool wait_for_reader() const;

  socket_t socket_;
  const std::string address_;
  RequestLimits limits_;
  ConnectionTimeouts timeouts_;

  std::string received_;  ///< from the socket, not yet taken
  bool ended_ = false;
  std::optional<Exchange> exchange_;
  std::string head_;  ///< what cpp-httplib reads first
  std::size_t head_read_ = 0;
  std::size_t body_read_ = 0;
  std::size_t discarded_ = 0;
  bool ending_ = false;

  std::string output_;  ///< written, not yet sent
  std::size_t sent_ = 0;
  httplib::ContentProvider body_;
  std::size_t body_offset_ = 0;
  std::size_t body_left_ = 0;
  bool streaming_ = false;
  std::optional<Clock::time_point> answer_deadline_;
};

}  // namespace rouleau::service
