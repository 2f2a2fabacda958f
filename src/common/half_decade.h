#pragma once

#include <cstdint>

namespace hexapod {

/// The largest of 1, 3, 10, 30, 100 .. that is not above the count (>= 1): when to do what is too
/// dear to be done often in a run of any length.
inline std::int64_t halfDecade(std::int64_t count) {
  std::int64_t decade = 1;
  while (count / decade >= 10) decade *= 10;
  return count / decade >= 3 ? 3 * decade : decade;
}

}  // namespace hexapod
