#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/error/checkpoint_error.h"

namespace rouleau {

/// What goes into the bytes as it lies in memory.
template <class Value>
concept Number = std::is_arithmetic_v<Value> || std::is_enum_v<Value>;
template <class Value>
concept Numbers = requires(Value& values) {
  values.resize(1);
  requires Number<std::remove_reference_t<decltype(values[0])>>;
};
template <class Value>
concept Records = requires(Value& values) {
  values.resize(1);
  requires !Number<std::remove_reference_t<decltype(values[0])>>;
};
template <class Value>
concept Array = requires {
  std::tuple_size<Value>::value;
};
template <class Value>
concept Optional = requires(Value& value) {
  value.has_value();
};

/// Values one after the other as bytes, in the order of this machine. ByteReader takes them back in the same
/// order: what lasts is listed once, in a function `visit(stream, value)` that serves both.
class ByteWriter {
 public:
  template <class... Values>
  void operator()(Values&... values) {
    (put(values), ...);
  }

  std::vector<std::byte> take() { return std::exchange(bytes_, {}); }

 private:
  template <class Value>
  void put(Value& value) {
    if constexpr (Number<Value>) {
      append(&value, sizeof(Value));
    } else if constexpr (Numbers<Value>) {
      put_size(value.size());
      append(value.data(), value.size() * sizeof(value[0]));
    } else if constexpr (Records<Value>) {
      put_size(value.size());
      for (auto& record : value) put(record);
    } else if constexpr (Array<Value>) {
      for (auto& record : value) put(record);
    } else if constexpr (Optional<Value>) {
      put_size(value.has_value() ? 1 : 0);
      if (value) put(*value);
    } else {
      visit(*this, value);
    }
  }
  void put_size(std::uint64_t size) { append(&size, sizeof(size)); }
  void append(const void* from, std::size_t size) {
    const auto* bytes = static_cast<const std::byte*>(from);
    bytes_.insert(bytes_.end(), bytes, bytes + size);
  }

  std::vector<std::byte> bytes_;
};

/// Reads what a ByteWriter wrote. Asks for no more memory than the bytes given call for.
/// @throws CheckpointError where they are too few
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : left_(bytes) {}

  template <class... Values>
  void operator()(Values&... values) {
    (get(values), ...);
  }

  bool at_end() const { return left_.empty(); }

 private:
  template <class Value>
  void get(Value& value) {
    if constexpr (Number<Value>) {
      take(&value, sizeof(Value));
    } else if constexpr (Numbers<Value>) {
      value.resize(get_size(sizeof(value[0])));
      take(value.data(), value.size() * sizeof(value[0]));
    } else if constexpr (Records<Value>) {
      value.resize(get_size(1));
      for (auto& record : value) get(record);
    } else if constexpr (Array<Value>) {
      for (auto& record : value) get(record);
    } else if constexpr (Optional<Value>) {
      value.reset();
      if (get_size(1) > 0) get(value.emplace());
    } else {
      visit(*this, value);
    }
  }
  std::size_t get_size(std::size_t least_bytes_each) {
    std::uint64_t size = 0;
    take(&size, sizeof(size));
    if (size > left_.size() / least_bytes_each) too_short();
    return static_cast<std::size_t>(size);
  }
  void take(void* to, std::size_t size) {
    if (size > left_.size()) too_short();
    if (size > 0) std::memcpy(to, left_.data(), size);
    left_ = left_.subspan(size);
  }
  [[noreturn]] static void too_short() {
    throw CheckpointError("the checkpoint is damaged: it is too short");
  }

  std::span<const std::byte> left_;
};

}  // namespace rouleau
