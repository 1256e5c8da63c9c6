#pragma once

#include <string>

namespace rouleau::service {

/// A connection that was accepted, or why none was.
struct Arrival {
  enum class Kind {
    accepted,
    nobody,         ///< no connection waits
    no_descriptors  ///< one waits and cannot be accepted now: the next could not be either
  };
  Kind kind = Kind::nobody;
  int descriptor = -1;  ///< of the connection, the caller's to close
  std::string address;  ///< numeric, of the peer
};

/// The next connection that waits at a listening socket that does not block.
Arrival next_arrival(int listener);

}  // namespace rouleau::service
