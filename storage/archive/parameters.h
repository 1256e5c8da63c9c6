#pragma once

#include <string>

#include <hdf5.h>

#include "engine/simulation/output.h"
#include "engine/simulation/run.h"

namespace rouleau::storage {

/// `/h5md`, which says what the file is, and `/parameters`: the case as given and as resolved, the plan, the
/// engine's version and the units of what is elsewhere.
void write_parameters(hid_t file, const RunHeader& header, const std::string& case_given);

/// How the run ended, under `/parameters`.
void write_ending(hid_t file, const RunSummary& summary);

}  // namespace rouleau::storage
