#pragma once

#include <stdexcept>

namespace rouleau {

/// A checkpoint that a run cannot go on from: it is another case's or another version's, or damaged.
class CheckpointError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace rouleau
