#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <type_traits>

namespace hexapod {

/// The bytes of one fuzzer's input, taken as values from the front; zeros once they are used up.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  template <typename Number>
  Number number() {
    static_assert(std::is_arithmetic_v<Number>, "only numbers are made of any bytes");
    Number value{};
    if (left_ < sizeof value) left_ = 0;
    if (left_ == 0) return value;
    std::memcpy(&value, data_, sizeof value);
    data_ += sizeof value;
    left_ -= sizeof value;
    return value;
  }

  bool isUsedUp() const { return left_ == 0; }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

/// A whole file; fuzzers run in the root of the checkout.
inline std::string contentOf(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline std::string textOf(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace hexapod
