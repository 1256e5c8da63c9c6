#pragma once

#include <stdexcept>
#include <string>

#include "storage/job.h"

namespace rouleau::storage {

/// The store could not do what was asked; nothing of the request is stored.
class StoreError : public std::runtime_error {
 public:
  enum class Kind {
    disk_full,         ///< goes on by itself when there is room
    io,                ///< the disk or the file system refused, a quota among others
    busy,              ///< the database stayed locked beyond the timeout
    corrupt,           ///< not a database, or a damaged one
    folder_in_use,     ///< another process holds the data folder
    schema_too_new,    ///< written by a newer version of this program
    invalid_argument,  ///< a page token that this store never gave out, a text that is no JSON
    internal,
  };

  StoreError(Kind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}

  Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

/// What was asked of a job does not exist in the state that it is in.
class InvalidTransition : public std::runtime_error {
 public:
  explicit InvalidTransition(JobState state);

  JobState state() const { return state_; }

 private:
  JobState state_;
};

/// A key that was used before for something else.
class IdempotencyMismatch : public std::runtime_error {
 public:
  IdempotencyMismatch() : std::runtime_error("the key was used before for another request") {}
};

}  // namespace rouleau::storage
