#pragma once

#include <cstdint>
#include <random>
#include <string>

namespace hexapod {

/// Seeded generator of everything random in this package.
///
/// Same seed, same sequence on every compiler: the engine is std::mt19937_64, whose output the
/// C++ standard fixes; the distributions are our own because the standard leaves those of
/// <random> to the library (libstdc++ changed one between g++ 10 and 11).
/// Not thread-safe: one generator per owner.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Restores a generator from state(). Throws std::invalid_argument when the text is not one.
  static Random fromState(const std::string& state);

  /// The whole state as text; fromState(state()) continues the same sequence.
  std::string state() const;

  /// Next 64 random bits.
  std::uint64_t bits() { return engine_(); }

  /// Uniform in 0 .. count - 1, without bias. count > 0.
  std::uint64_t below(std::uint64_t count);

  /// Uniform in [0, 1), 53 random bits.
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Normally distributed, mean 0, standard deviation 1.
  double normal();

  /// True with the given probability (0: never, 1: always).
  bool chance(double probability) { return uniform() < probability; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace hexapod
