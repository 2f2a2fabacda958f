#pragma once

#include <cstdint>

namespace hexapod {

/// A millisecond [ns].
constexpr std::int64_t kMs = 1'000'000;

}  // namespace hexapod
