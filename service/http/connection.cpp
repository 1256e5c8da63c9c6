#include "service/http/connection.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <utility>

#include "service/http/problem.h"
#include "service/http/request_id.h"

namespace rouleau::service {

namespace {

constexpr std::size_t most_at_a_time = 65536;
constexpr std::size_t most_unsent_of_a_stream = 262144;

bool would_block(int error) {
  return error == EAGAIN || error == EWOULDBLOCK;
}

}  // namespace

Connection::Connection(socket_t socket, std::string address, const RequestLimits& limits,
                       const ConnectionTimeouts& timeouts)
    : socket_(socket), address_(std::move(address)), limits_(limits), timeouts_(timeouts) {}

Connection::~Connection() {
  ::close(socket_);
}

void Connection::receive() {
  std::array<char, most_at_a_time> buffer;
  const ssize_t count = ::recv(socket_, buffer.data(), buffer.size(), 0);
  if (count > 0) {
    received_.append(buffer.data(), static_cast<std::size_t>(count));
  } else if (count == 0 || (errno != EINTR && !would_block(errno))) {
    ended_ = true;
  }
}

bool Connection::begin_exchange() {
  if (exchange_) return true;
  const auto end = received_.find("\r\n\r\n");
  if (std::min(end, received_.size()) > limits_.head_bytes) {
    throw Problem(problems::headers_too_large,
                  "at most " + std::to_string(limits_.head_bytes) + " bytes are read");
  }
  if (end == std::string::npos) return false;
  const std::size_t size = end + 4;
  RequestHead head = read_request_head(std::string_view(received_).substr(0, size), limits_);
  received_.erase(0, size);
  head_ = head_for_httplib(head);
  head_read_ = 0;
  body_read_ = 0;
  exchange_.emplace(Exchange{std::move(head), new_request_id(), Clock::now(), {}});
  return true;
}

bool Connection::request_is_whole() const {
  return exchange_ && received_.size() >= exchange_->head.content_length;
}

void Connection::end_exchange() {
  if (request_is_whole()) {
    received_.erase(0, exchange_->head.content_length);
    // A large body must not keep its room for as long as the connection lasts.
    received_.shrink_to_fit();
  } else {
    ending_ = true;
  }
  exchange_.reset();
  streaming_ = false;
}

void Connection::end() {
  ::shutdown(socket_, SHUT_WR);
  received_ = {};
}

bool Connection::discard() {
  std::array<char, most_at_a_time> buffer;
  const ssize_t count = ::recv(socket_, buffer.data(), buffer.size(), 0);
  if (count < 0) return errno == EINTR || would_block(errno);
  discarded_ += static_cast<std::size_t>(count);
  return count > 0 && discarded_ < 2 * limits_.body_bytes;
}

void Connection::attach(httplib::ContentProvider provider, std::size_t length) {
  body_ = std::move(provider);
  body_offset_ = 0;
  body_left_ = length;
}

bool Connection::send_output() {
  while (sent_ < output_.size()) {
    const ssize_t count =
        ::send(socket_, output_.data() + sent_, output_.size() - sent_, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count >= 0) {
      sent_ += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      return would_block(errno);
    }
  }
  output_ = {};
  sent_ = 0;
  return true;
}

bool Connection::fetch_body() {
  httplib::DataSink sink;
  sink.write = [this](const char* data, std::size_t size) {
    output_.append(data, size);
    return true;
  };
  sink.is_writable = [] { return true; };
  if (!body_(body_offset_, body_left_, sink) || output_.empty()) return false;
  const std::size_t fetched = std::min(output_.size(), body_left_);
  body_offset_ += fetched;
  body_left_ -= fetched;
  if (body_left_ == 0) body_ = nullptr;
  return true;
}

void Connection::begin_stream() {
  streaming_ = true;
  // Else a peer that vanished without a word is noticed after a quarter of an hour.
  const auto patience = static_cast<unsigned>(timeouts_.unheard.count());
  ::setsockopt(socket_, IPPROTO_TCP, TCP_USER_TIMEOUT, &patience, sizeof(patience));
}

bool Connection::flush() {
  do {
    if (output_.empty() && body_left_ > 0 && !fetch_body()) return false;
    if (!send_output()) return false;
  } while (output_.empty() && body_left_ > 0);
  if (!has_output()) {
    answer_deadline_.reset();
  } else if (!answer_deadline_) {
    const std::size_t size = output_.size() - sent_ + body_left_;
    answer_deadline_ =
        Clock::now() + timeouts_.answer + std::chrono::seconds(size / timeouts_.least_bytes_per_second);
  }
  return true;
}

bool Connection::wait_for_reader() const {
  pollfd entry{socket_, POLLOUT, 0};
  return ::poll(&entry, 1, static_cast<int>(timeouts_.silence.count())) > 0;
}

bool Connection::is_writable() const {
  if (!streaming_) return true;
  std::array<char, 1> probe;
  const ssize_t peeked = ::recv(socket_, probe.data(), probe.size(), MSG_PEEK | MSG_DONTWAIT);
  const bool open = peeked > 0 || (peeked < 0 && would_block(errno));
  return open && wait_for_reader();
}

ssize_t Connection::read(char* data, size_t size) {
  if (head_read_ < head_.size()) {
    const auto count = std::min(size, head_.size() - head_read_);
    std::memcpy(data, head_.data() + head_read_, count);
    head_read_ += count;
    return static_cast<ssize_t>(count);
  }
  if (!request_is_whole()) return -1;
  const auto count = std::min(size, exchange_->head.content_length - body_read_);
  std::memcpy(data, received_.data() + body_read_, count);
  body_read_ += count;
  return static_cast<ssize_t>(count);
}

ssize_t Connection::write(const char* data, size_t size) {
  output_.append(data, size);
  if (streaming_) {
    if (!send_output()) return -1;
    while (output_.size() - sent_ > most_unsent_of_a_stream) {
      if (!wait_for_reader() || !send_output()) return -1;
    }
    output_.erase(0, std::exchange(sent_, 0));
  }
  return static_cast<ssize_t>(size);
}

void Connection::get_remote_ip_and_port(std::string& ip, int& port) const {
  ip = address_;
  port = 0;
}

}  // namespace rouleau::service
