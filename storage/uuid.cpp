#include "storage/uuid.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <random>

namespace rouleau::storage {

namespace {

constexpr std::uint64_t low_bits = (std::uint64_t{1} << 62) - 1;
constexpr std::uint16_t high_bits = 0xfff;

std::uint64_t random_bits() {
  static thread_local std::random_device device;
  return (static_cast<std::uint64_t>(device()) << 32) | device();
}

std::uint64_t hex_value(std::string_view digits) {
  std::uint64_t value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  return value;
}

}  // namespace

std::string UuidSource::next(TimeMs now) {
  const auto time = static_cast<std::uint64_t>(std::max<TimeMs>(now, 0));
  if (time > time_) {
    time_ = time;
    high_ = static_cast<std::uint16_t>(random_bits() & high_bits);
    low_ = random_bits() & low_bits;
  } else if (low_ < low_bits) {
    ++low_;
  } else {
    low_ = 0;
    if (high_ == high_bits) ++time_;
    high_ = static_cast<std::uint16_t>((high_ + 1) & high_bits);
  }
  std::array<char, 80> text{};  // 37 are used; room for what the fields could hold by their types
  std::snprintf(text.data(), text.size(), "%08llx-%04llx-7%03x-%04llx-%012llx",
                static_cast<unsigned long long>(time_ >> 16), static_cast<unsigned long long>(time_ & 0xffff),
                high_, static_cast<unsigned long long>(0x8000 | (low_ >> 48)),
                static_cast<unsigned long long>(low_ & 0xffffffffffff));
  return std::string(text.data());
}

void UuidSource::start_after(std::string_view id) {
  if (!is_uuid(id)) return;
  time_ = (hex_value(id.substr(0, 8)) << 16) | hex_value(id.substr(9, 4));
  high_ = static_cast<std::uint16_t>(hex_value(id.substr(14, 4)) & high_bits);
  low_ = ((hex_value(id.substr(19, 4)) << 48) | hex_value(id.substr(24, 12))) & low_bits;
}

bool is_uuid(std::string_view text) {
  if (text.size() != 36) return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool dash = i == 8 || i == 13 || i == 18 || i == 23;
    const bool digit = (text[i] >= '0' && text[i] <= '9') || (text[i] >= 'a' && text[i] <= 'f');
    if (dash ? text[i] != '-' : !digit) return false;
  }
  return true;
}

}  // namespace rouleau::storage
