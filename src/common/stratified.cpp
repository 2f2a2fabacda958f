#include "common/stratified.h"

#include <utility>

namespace hexapod {

std::vector<double> stratified(std::size_t count, double low, double high, Random& random) {
  std::vector<double> values(count);
  const double part = (high - low) / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = low + part * (static_cast<double>(i) + random.uniform());
  }
  for (std::size_t i = count; i > 1; --i) std::swap(values[i - 1], values[random.below(i)]);
  return values;
}

}  // namespace hexapod
