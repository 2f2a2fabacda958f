#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace hexapod {

/// The latest value of one writing thread for one reading thread. Neither ever waits for the other.
/// Values are assigned, so vectors of equal size are handed over without allocating.
template <typename T>
class TripleBuffer {
 public:
  explicit TripleBuffer(const T& initial) : slots_{initial, initial, initial} {}

  /// Writing thread only.
  void write(const T& value) {
    slots_[writing_] = value;
    writing_ = between_.exchange(static_cast<std::uint8_t>(writing_ | kNew)) & kIndex;
  }

  /// Reading thread only: true when a value was written since the last call; value() is then it.
  bool update() {
    if (!(between_.load() & kNew)) return false;
    reading_ = between_.exchange(reading_) & kIndex;
    return true;
  }

  /// Reading thread only.
  const T& value() const { return slots_[reading_]; }

 private:
  static constexpr std::uint8_t kIndex = 3;
  static constexpr std::uint8_t kNew = 4;

  std::array<T, 3> slots_;
  std::uint8_t writing_ = 0;
  std::atomic<std::uint8_t> between_{1};
  std::uint8_t reading_ = 2;
};

}  // namespace hexapod
