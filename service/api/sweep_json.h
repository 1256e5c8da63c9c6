#pragma once

#include <nlohmann/json_fwd.hpp>

#include "service/sweep/sweep_body.h"
#include "storage/sweep.h"

namespace rouleau::service {

/// A sweep without its jobs: what it was given beside its case, and how many jobs are in which state.
nlohmann::json to_json(const storage::Sweep& sweep);

/// A job as its sweep lists it, with the values that it has on the axes.
nlohmann::json to_json(const storage::SweepJob& job, const SweepBody& body);

/// The axes of a sweep that was accepted once.
SweepBody body_of(const storage::Sweep& sweep);

}  // namespace rouleau::service
