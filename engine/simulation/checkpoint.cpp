#include "engine/simulation/checkpoint.h"

#include <nlohmann/json.hpp>

#include "engine/case/case_json.h"
#include "engine/simulation/run.h"

namespace rouleau {

namespace {

constexpr std::uint64_t mark = 0x746e696f706b6368;  // "hckpoint", and the order of bytes
constexpr std::uint32_t format = 2;

template <class Stream>
void visit(Stream& stream, CheckpointHead& head) {
  auto& [simulated_time, steps, rows, frames] = head;
  stream(simulated_time, steps, rows, frames);
}

}  // namespace

void write_head(ByteWriter& bytes, CheckpointHead head, const Case& resolved) {
  std::string version = engine_version(), text = to_json(resolved).dump();
  bytes(mark, format, version, text);
  visit(bytes, head);
}

CheckpointHead read_head(ByteReader& bytes, const Case& resolved) {
  std::uint64_t found_mark = 0;
  std::uint32_t found_format = 0;
  bytes(found_mark);
  if (found_mark != mark) throw CheckpointError("this is no checkpoint of this kind of machine");
  bytes(found_format);
  if (found_format != format) {
    throw CheckpointError("the checkpoint has format " + std::to_string(found_format) +
                          ", this version goes on from format " + std::to_string(format) + " alone");
  }
  std::string version, text;
  bytes(version);
  if (version != engine_version()) {
    throw CheckpointError("the checkpoint is of version " + version + ", this is " + engine_version() +
                          ": only the version that wrote it gives the same numbers");
  }
  bytes(text);
  if (text != to_json(resolved).dump()) throw CheckpointError("the checkpoint is another case's");
  CheckpointHead head;
  visit(bytes, head);
  if (head.rows < 0 || head.frames < 0)
    throw CheckpointError("the checkpoint is damaged: it counts backwards");
  return head;
}

CheckpointHead head_of(const Checkpoint& checkpoint, const Case& resolved) {
  ByteReader bytes(checkpoint.bytes);
  return read_head(bytes, resolved);
}

}  // namespace rouleau
