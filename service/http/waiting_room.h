#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "service/http/connection.h"
#include "service/http/descriptor.h"
#include "service/http/problem.h"

namespace rouleau::service {

struct RoomLimits {
  std::size_t connections = 4096;
  std::size_t connections_of_an_address = 2048;  ///< generous: behind a proxy all come from one
  std::size_t held_bytes = 256 << 20;            ///< of requests and answers under way
};

/// Whom a waiting room works for.
class Reception {
 public:
  virtual ~Reception() = default;

  /// A whole head is there: decides about it.
  virtual void admit(Connection& connection) = 0;

  /// What to send where no exchange has begun.
  virtual std::string refusal(const Connection& connection, const Problem& problem) = 0;

  /// A request is whole or refused, or the peer takes more of an answer. To be given back by `take_back`,
  /// from any thread.
  virtual void serve(std::unique_ptr<Connection> connection) = 0;
};

/// Holds the connections for which there is nothing to do, all of them on one thread: those that are idle,
/// whose request has not arrived yet, or whose peer does not take its answer. So a slow or silent client
/// costs memory, never a thread, and not for long.
class WaitingRoom {
 public:
  WaitingRoom(Reception& reception, const RoomLimits& limits, const RequestLimits& request_limits,
              const ConnectionTimeouts& timeouts);

  /// Lets in who connects to `listener`, until `stop`; answers under way are sent first.
  void run(int listener);

  /// From any thread.
  void stop();

  /// @param usable whether the connection can go on
  void take_back(std::unique_ptr<Connection> connection, bool usable);

  /// Connections that there are, whether they wait here or are served.
  std::size_t connections() const { return connections_; }

 private:
  using Clock = Connection::Clock;
  enum class Phase { idle, head, body, answer, goodbye };
  struct Guest {
    std::unique_ptr<Connection> connection;
    Phase phase = Phase::answer;
    Clock::time_point deadline{};
  };

  void let_in(int listener);
  void greet(int descriptor, const std::string& address);
  void settle_returned();
  void on_event(int descriptor);
  void proceed(int descriptor, Guest& guest);
  void hand_over(int descriptor, Guest& guest);
  void refuse(int descriptor, Guest& guest, const Problem& problem);
  void after_answer(int descriptor, Guest& guest);
  void enter(Guest& guest, Phase phase);
  void wait_for(int descriptor, std::uint32_t events);
  void close(int descriptor);
  void forget(const Connection& connection);
  void expire(Clock::time_point now);
  void spare_memory();
  void close_those_that_wait();
  void wake();

  Reception& reception_;
  const RoomLimits limits_;
  const RequestLimits request_limits_;
  const ConnectionTimeouts timeouts_;
  Descriptor epoll_;
  Descriptor bell_;
  std::unordered_map<int, Guest> guests_;
  std::map<std::string, std::size_t> of_address_;
  std::atomic<std::size_t> connections_ = 0;
  std::unordered_map<const Connection*, std::size_t>
      away_;                      ///< being served, and what they held when they went
  std::size_t held_by_away_ = 0;  ///< bytes
  bool door_is_stuck_ = false;    ///< no connection can be accepted for want of descriptors

  std::mutex mutex_;
  std::vector<std::pair<std::unique_ptr<Connection>, bool>> returned_;
  std::atomic<bool> stopping_ = false;
};

}  // namespace rouleau::service
