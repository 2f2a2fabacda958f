#include "common/random.h"

#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>

namespace hexapod {

Random Random::fromState(const std::string& state) {
  Random random(0);
  std::istringstream text(state);
  text.imbue(std::locale::classic());
  text >> random.engine_;
  if (!text) throw std::invalid_argument("The generator state is not one of std::mt19937_64.");
  return random;
}

std::string Random::state() const {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << engine_;
  return text.str();
}

// Polar method; the second value is thrown away.
double Random::normal() {
  for (;;) {
    const double u = uniform(-1.0, 1.0), v = uniform(-1.0, 1.0);
    const double square = u * u + v * v;
    if (square > 0.0 && square < 1.0) return u * std::sqrt(-2.0 * std::log(square) / square);
  }
}

std::uint64_t Random::below(std::uint64_t count) {
  // Draw again in the incomplete last block, so that every remainder is equally likely.
  const std::uint64_t max = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t limit = max - max % count;
  std::uint64_t drawn = bits();
  while (drawn >= limit) drawn = bits();
  return drawn % count;
}

}  // namespace hexapod
