#include <cstddef>
#include <cstdint>

#include "tests/fuzz/targets.h"

// libFuzzer's; ROULEAU_FUZZ_TARGET is the target that this program is for.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rouleau::fuzz::ROULEAU_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}
