#pragma once

#include "engine/bytes/byte_stream.h"
#include "engine/case/case.h"
#include "engine/simulation/output.h"

namespace rouleau {

/// How far a run had come at a checkpoint, and what it had delivered by then.
struct CheckpointHead {
  double simulated_time = 0;  ///< s
  long steps = 0;
  long rows = 0;  ///< of the series, and of the probes
  long frames = 0;
};

/// What a checkpoint says of itself.
/// @throws CheckpointError if it is damaged, another version's, or another case's than `resolved`
CheckpointHead head_of(const Checkpoint& checkpoint, const Case& resolved);

/// The same at the start of the bytes, for the run.
void write_head(ByteWriter& bytes, CheckpointHead head, const Case& resolved);
CheckpointHead read_head(ByteReader& bytes, const Case& resolved);

}  // namespace rouleau
