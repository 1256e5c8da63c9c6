#include "service/http/connection.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>

#include "service/http/problem.h"

namespace rouleau::service {

namespace {

constexpr std::chrono::milliseconds stop_check_interval{100};

}  // namespace

Connection::Connection(socket_t socket, const RequestLimits& limits, const ConnectionTimeouts& timeouts)
    : socket_(socket), limits_(limits), timeouts_(timeouts) {}

Connection::~Connection() {
  ::close(socket_);
}

bool Connection::wait_until(short events, Clock::time_point deadline) const {
  for (;;) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    pollfd entry{socket_, events, 0};
    const int ready = ::poll(&entry, 1, static_cast<int>(std::max<long>(left, 0)));
    if (ready > 0) return true;
    if (ready == 0 || errno != EINTR) return false;
  }
}

bool Connection::receive(Clock::time_point deadline) {
  if (!wait_until(POLLIN, deadline)) return false;
  std::array<char, 8192> buffer;
  const ssize_t count = ::recv(socket_, buffer.data(), buffer.size(), 0);
  if (count <= 0) return false;
  received_.append(buffer.data(), static_cast<std::size_t>(count));
  return true;
}

bool Connection::wait_for_request(const std::function<bool()>& stopping) {
  const auto deadline = Clock::now() + timeouts_.idle;
  while (received_.empty()) {
    if (stopping()) return false;
    const auto now = Clock::now();
    if (now >= deadline) return false;
    if (wait_until(POLLIN, std::min(deadline, now + stop_check_interval))) return receive(deadline);
  }
  return true;
}

std::string_view Connection::take_head() {
  const auto end = received_.find("\r\n\r\n");
  if (end == std::string::npos) {
    if (received_.size() > limits_.head_bytes) {
      throw Problem(problems::headers_too_large,
                    "at most " + std::to_string(limits_.head_bytes) + " bytes are read");
    }
    return {};
  }
  if (end > limits_.head_bytes) {
    throw Problem(problems::headers_too_large,
                  "at most " + std::to_string(limits_.head_bytes) + " bytes are read");
  }
  return std::string_view(received_).substr(0, end + 4);
}

RequestHead Connection::next_request() {
  const auto deadline = Clock::now() + timeouts_.head;
  std::string_view text = take_head();
  while (text.empty()) {
    if (!receive(deadline)) throw Problem(problems::request_timeout, "the head did not arrive");
    text = take_head();
  }
  RequestHead head = read_request_head(text, limits_);
  received_.erase(0, text.size());
  head_ = head_for_httplib(head);
  head_read_ = 0;
  body_left_ = head.content_length;
  body_deadline_ = Clock::now() + timeouts_.body;
  return head;
}

void Connection::close_gently() {
  ::shutdown(socket_, SHUT_WR);
  const auto deadline = Clock::now() + std::chrono::milliseconds(500);
  std::size_t taken = 0;
  while (taken < 2 * limits_.body_bytes && receive(deadline)) {
    taken += received_.size();
    received_.clear();
  }
}

bool Connection::is_readable() const {
  return wait_until(POLLIN, Clock::now());
}

bool Connection::is_writable() const {
  std::array<char, 1> probe;
  const ssize_t peeked = ::recv(socket_, probe.data(), probe.size(), MSG_PEEK | MSG_DONTWAIT);
  const bool open = peeked > 0 || (peeked < 0 && (errno == EAGAIN || errno == EWOULDBLOCK));
  return open && wait_until(POLLOUT, Clock::now() + timeouts_.silence);
}

ssize_t Connection::read(char* data, size_t size) {
  if (head_read_ < head_.size()) {
    const auto count = std::min(size, head_.size() - head_read_);
    std::memcpy(data, head_.data() + head_read_, count);
    head_read_ += count;
    return static_cast<ssize_t>(count);
  }
  if (body_left_ == 0) return 0;
  if (received_.empty() && !receive(std::min(body_deadline_, Clock::now() + timeouts_.silence))) return -1;
  const auto count = std::min({size, body_left_, received_.size()});
  std::memcpy(data, received_.data(), count);
  received_.erase(0, count);
  body_left_ -= count;
  return static_cast<ssize_t>(count);
}

ssize_t Connection::write(const char* data, size_t size) {
  const auto deadline = Clock::now() + timeouts_.silence;
  for (;;) {
    if (!wait_until(POLLOUT, deadline)) return -1;
    const ssize_t count = ::send(socket_, data, size, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count >= 0) return count;
    if (errno != EINTR && errno != EAGAIN && errno != EWOULDBLOCK) return -1;
  }
}

void Connection::get_remote_ip_and_port(std::string& ip, int& port) const {
  sockaddr_storage address{};
  socklen_t length = sizeof(address);
  std::array<char, NI_MAXHOST> host{};
  std::array<char, NI_MAXSERV> service{};
  auto* const generic = reinterpret_cast<sockaddr*>(&address);
  if (::getpeername(socket_, generic, &length) != 0 ||
      ::getnameinfo(generic, length, host.data(), host.size(), service.data(), service.size(),
                    NI_NUMERICHOST | NI_NUMERICSERV) != 0) {
    return;
  }
  ip = host.data();
  port = std::atoi(service.data());
}

void Connection::get_local_ip_and_port(std::string&, int&) const {}

}  // namespace rouleau::service
