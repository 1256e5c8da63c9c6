#pragma once

#include <utility>

#include "service/http/problem.h"
#include "storage/job.h"
#include "storage/store_error.h"

namespace rouleau::service {

// What the store refuses, as the problems that are answered.

/// Runs what stores a submission, or looks for an earlier one with its key.
/// @throws Problem 422 idempotency-mismatch, 503 unavailable
template <class Store>
auto submitted(Store&& store) {
  try {
    return std::forward<Store>(store)();
  } catch (const storage::IdempotencyMismatch& error) {
    throw Problem(problems::idempotency_mismatch, error.what());
  } catch (const storage::StoreError& error) {
    throw Problem(problems::unavailable, error.what());
  }
}

/// Runs what reads a page of a list.
/// @throws Problem 400 where no page gave the token
template <class Read>
auto listed(Read&& read) {
  try {
    return std::forward<Read>(read)();
  } catch (const storage::StoreError& error) {
    if (error.kind() != storage::StoreError::Kind::invalid_argument) throw;
    throw Problem(problems::invalid_request, "the query is not valid",
                  {{"?page_token", "not a token that this server gave out"}});
  }
}

}  // namespace rouleau::service
