#include "service/http/waiting_room.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <optional>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <system_error>

#include "service/http/arrival.h"

namespace rouleau::service {

namespace {

constexpr std::chrono::milliseconds round_interval{100};
// Those past the limit that are told so; even more are closed without a word.
constexpr std::size_t most_turned_away = 256;
constexpr int most_let_in_at_once = 64;
// Answers that are still being sent when the server stops.
constexpr std::chrono::seconds grace{2};

int checked(int result, const char* what) {
  if (result < 0) throw std::system_error(errno, std::generic_category(), what);
  return result;
}

}  // namespace

WaitingRoom::WaitingRoom(Reception& reception, const RoomLimits& limits, const RequestLimits& request_limits,
                         const ConnectionTimeouts& timeouts)
    : reception_(reception),
      limits_(limits),
      request_limits_(request_limits),
      timeouts_(timeouts),
      epoll_(checked(::epoll_create1(EPOLL_CLOEXEC), "epoll_create1")),
      bell_(checked(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK), "eventfd")) {
  epoll_event event{EPOLLIN, {.fd = bell_.number()}};
  checked(::epoll_ctl(epoll_.number(), EPOLL_CTL_ADD, bell_.number(), &event), "epoll_ctl");
}

void WaitingRoom::run(int listener) {
  epoll_event listening{EPOLLIN | EPOLLONESHOT, {.fd = listener}};
  checked(::epoll_ctl(epoll_.number(), EPOLL_CTL_ADD, listener, &listening), "epoll_ctl");
  std::array<epoll_event, 256> events;
  auto next_round = Clock::now();
  std::optional<Clock::time_point> give_up;
  for (;;) {
    const bool somebody_waits = !guests_.empty() || door_is_stuck_;
    const int timeout = somebody_waits ? static_cast<int>(round_interval.count()) : -1;
    const int count = ::epoll_wait(epoll_.number(), events.data(), static_cast<int>(events.size()), timeout);
    if (count < 0 && errno != EINTR) checked(count, "epoll_wait");
    const bool stopping = stopping_;
    for (int i = 0; i < count; ++i) {
      const int descriptor = events[static_cast<std::size_t>(i)].data.fd;
      if (descriptor == listener) {
        if (!stopping) let_in(listener);
      } else if (descriptor == bell_.number()) {
        std::uint64_t rings = 0;
        [[maybe_unused]] const ssize_t size = ::read(bell_.number(), &rings, sizeof(rings));
      } else {
        on_event(descriptor);
      }
    }
    settle_returned();
    const auto now = Clock::now();
    if (now >= next_round) {
      expire(now);
      spare_memory();
      if (std::exchange(door_is_stuck_, false) && !stopping) let_in(listener);
      next_round = now + round_interval;
    }
    if (stopping) {
      close_those_that_wait();
      if (!give_up) give_up = now + grace;
      if (away_.empty() && (guests_.empty() || now >= *give_up)) break;
    }
  }
  while (!guests_.empty()) close(guests_.begin()->first);
}

void WaitingRoom::stop() {
  stopping_ = true;
  wake();
}

void WaitingRoom::take_back(std::unique_ptr<Connection> connection, bool usable) {
  {
    const std::lock_guard lock(mutex_);
    returned_.emplace_back(std::move(connection), usable);
  }
  wake();
}

void WaitingRoom::wake() {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t size = ::write(bell_.number(), &one, sizeof(one));
}

void WaitingRoom::let_in(int listener) {
  for (int i = 0; i < most_let_in_at_once; ++i) {
    const Arrival arrival = next_arrival(listener);
    if (arrival.kind == Arrival::Kind::no_descriptors) {
      // Only once some time has passed is it tried again.
      door_is_stuck_ = true;
      return;
    }
    if (arrival.kind == Arrival::Kind::nobody) break;
    greet(arrival.descriptor, arrival.address);
  }
  wait_for(listener, EPOLLIN);
}

void WaitingRoom::greet(int descriptor, const std::string& address) {
  auto connection = std::make_unique<Connection>(descriptor, address, request_limits_, timeouts_);
  if (connections_ >= limits_.connections + most_turned_away) return;
  epoll_event event{EPOLLIN | EPOLLONESHOT, {.fd = descriptor}};
  if (::epoll_ctl(epoll_.number(), EPOLL_CTL_ADD, descriptor, &event) != 0) return;
  const bool full = ++connections_ > limits_.connections;
  const bool too_many = ++of_address_[address] > limits_.connections_of_an_address;
  Guest& guest = guests_[descriptor] = Guest{std::move(connection)};
  enter(guest, Phase::idle);
  if (full || too_many) {
    refuse(descriptor, guest,
           Problem(problems::too_many_connections,
                   full ? "the server has as many connections as it takes"
                        : "your address has as many connections as one may have"));
  }
}

void WaitingRoom::settle_returned() {
  std::vector<std::pair<std::unique_ptr<Connection>, bool>> returned;
  {
    const std::lock_guard lock(mutex_);
    returned.swap(returned_);
  }
  for (auto& [connection, usable] : returned) {
    const auto away = away_.find(connection.get());
    held_by_away_ -= away->second;
    away_.erase(away);
    if (!usable) {
      forget(*connection);
      continue;
    }
    const int descriptor = connection->descriptor();
    Guest& guest = guests_[descriptor] = Guest{std::move(connection)};
    after_answer(descriptor, guest);
  }
}

void WaitingRoom::on_event(int descriptor) {
  const auto found = guests_.find(descriptor);
  if (found == guests_.end()) return;
  Guest& guest = found->second;
  switch (guest.phase) {
    case Phase::answer:
      hand_over(descriptor, guest);
      break;
    case Phase::goodbye:
      if (guest.connection->discard()) {
        wait_for(descriptor, EPOLLIN);
      } else {
        close(descriptor);
      }
      break;
    default:
      guest.connection->receive();
      proceed(descriptor, guest);
  }
}

void WaitingRoom::proceed(int descriptor, Guest& guest) {
  Connection& connection = *guest.connection;
  try {
    const bool begun_before = connection.exchange() != nullptr;
    const bool begun = connection.begin_exchange();
    if (begun && !begun_before) reception_.admit(connection);
    if (begun && (connection.request_is_whole() || connection.exchange()->admission.refusal)) {
      hand_over(descriptor, guest);
      return;
    }
    if (connection.has_ended()) {
      close(descriptor);
      return;
    }
    enter(guest, begun ? Phase::body : connection.has_received() ? Phase::head : Phase::idle);
    wait_for(descriptor, EPOLLIN);
  } catch (const Problem& problem) {
    refuse(descriptor, guest, problem);
  }
}

void WaitingRoom::hand_over(int descriptor, Guest& guest) {
  const std::size_t held = guest.connection->held_bytes();
  const bool is_request = guest.phase != Phase::answer;
  if (is_request && held_by_away_ + held > limits_.held_bytes) {
    refuse(descriptor, guest, Problem(problems::unavailable, "more requests wait than the server can hold"));
    return;
  }
  auto connection = std::move(guest.connection);
  guests_.erase(descriptor);
  held_by_away_ += held;
  away_.emplace(connection.get(), held);
  reception_.serve(std::move(connection));
}

void WaitingRoom::refuse(int descriptor, Guest& guest, const Problem& problem) {
  Connection& connection = *guest.connection;
  const std::string text = reception_.refusal(connection, problem);
  connection.write(text.data(), text.size());
  connection.end_after_answer();
  if (connection.flush()) {
    after_answer(descriptor, guest);
  } else {
    close(descriptor);
  }
}

void WaitingRoom::after_answer(int descriptor, Guest& guest) {
  Connection& connection = *guest.connection;
  if (connection.has_output()) {
    guest.phase = Phase::answer;
    guest.deadline = connection.answer_deadline();
    wait_for(descriptor, EPOLLOUT);
  } else if (connection.is_ending()) {
    connection.end();
    enter(guest, Phase::goodbye);
    wait_for(descriptor, EPOLLIN);
  } else {
    proceed(descriptor, guest);
  }
}

void WaitingRoom::enter(Guest& guest, Phase phase) {
  if (guest.phase == phase) return;
  guest.phase = phase;
  const auto now = Clock::now();
  switch (phase) {
    case Phase::idle:
      guest.deadline = now + timeouts_.idle;
      break;
    case Phase::head:
      guest.deadline = now + timeouts_.head;
      break;
    case Phase::body:
      guest.deadline = now + timeouts_.body;
      break;
    case Phase::goodbye:
      guest.deadline = now + timeouts_.goodbye;
      break;
    case Phase::answer:
      break;
  }
}

void WaitingRoom::wait_for(int descriptor, std::uint32_t events) {
  epoll_event event{events | EPOLLONESHOT, {.fd = descriptor}};
  checked(::epoll_ctl(epoll_.number(), EPOLL_CTL_MOD, descriptor, &event), "epoll_ctl");
}

void WaitingRoom::close(int descriptor) {
  const auto found = guests_.find(descriptor);
  forget(*found->second.connection);
  guests_.erase(found);
}

void WaitingRoom::forget(const Connection& connection) {
  --connections_;
  const auto found = of_address_.find(connection.address());
  if (--found->second == 0) of_address_.erase(found);
}

void WaitingRoom::expire(Clock::time_point now) {
  std::vector<int> expired;
  for (const auto& [descriptor, guest] : guests_) {
    if (now >= guest.deadline) expired.push_back(descriptor);
  }
  for (const int descriptor : expired) {
    Guest& guest = guests_.at(descriptor);
    if (guest.phase == Phase::head || guest.phase == Phase::body) {
      const std::string what = guest.phase == Phase::head ? "head" : "body";
      refuse(descriptor, guest,
             Problem(problems::request_timeout, "the " + what + " did not arrive in time"));
    } else {
      close(descriptor);
    }
  }
}

void WaitingRoom::spare_memory() {
  std::size_t held = held_by_away_;
  for (const auto& [descriptor, guest] : guests_) held += guest.connection->held_bytes();
  while (held > limits_.held_bytes && !guests_.empty()) {
    const auto largest =
        std::max_element(guests_.begin(), guests_.end(), [](const auto& left, const auto& right) {
          return left.second.connection->held_bytes() < right.second.connection->held_bytes();
        });
    if (largest->second.connection->held_bytes() == 0) return;
    held -= largest->second.connection->held_bytes();
    close(largest->first);
  }
}

void WaitingRoom::close_those_that_wait() {
  std::vector<int> waiting;
  for (const auto& [descriptor, guest] : guests_) {
    if (guest.phase != Phase::answer && guest.phase != Phase::goodbye) waiting.push_back(descriptor);
  }
  for (const int descriptor : waiting) close(descriptor);
}

}  // namespace rouleau::service
