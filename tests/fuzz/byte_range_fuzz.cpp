#include <charconv>
#include <cstdint>

#include "service/http/byte_range.h"
#include "service/http/duration.h"
#include "tests/fuzz/targets.h"

namespace rouleau::fuzz {

/// SIZE, a line end, the header.
void byte_range(std::string_view input) {
  const auto line_end = input.find('\n');
  if (line_end == std::string_view::npos) return;
  std::uint64_t size = 0;
  std::from_chars(input.data(), input.data() + line_end, size);
  const std::string_view header = input.substr(line_end + 1);
  const auto range = service::parse_byte_range(header, size);
  if (range.kind == service::ByteRange::Kind::part) {
    must(range.first <= range.last && range.last < size && range.length() <= size);
  }
  if (const auto duration = service::parse_duration(header)) must(duration->count() >= 0);
}

}  // namespace rouleau::fuzz
