#pragma once

#include <cstddef>
#include <vector>

#include "common/random.h"

namespace hexapod {

/// One value in each of `count` equal parts of low .. high, in random order: several quantities
/// drawn so are a Latin hypercube, of which few samples cover all of the range.
std::vector<double> stratified(std::size_t count, double low, double high, Random& random);

}  // namespace hexapod
