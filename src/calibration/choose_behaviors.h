#pragma once

#include <cstddef>
#include <vector>

#include "repertoire/repertoire.h"
#include "self_model/body.h"
#include "self_model/imagination.h"

namespace hexapod {

/// The entries, by index, that tell bodies apart best, in an order that keeps the robot near to
/// where it begins.
///
/// Every entry is imagined in bodies a standard deviation of what is possible
/// (possibleDeviations()) to either side of the nominal one; those that fail in any of them are
/// left out. Of the others each is added that tells most of what those before leave open: the
/// largest determinant of the information of the parameters. `noise_m`, `noise_rad`: of an end pose
/// about the right body's. Throws std::invalid_argument when fewer than `count` are left.
std::vector<std::size_t> chooseBehaviors(const Imagination& imagination, const Physics& nominal,
                                         const std::vector<Entry>& entries, std::size_t count,
                                         double noise_m, double noise_rad);

}  // namespace hexapod
