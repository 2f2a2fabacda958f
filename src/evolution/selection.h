#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "evolution/individual.h"
#include "evolution/nsga2.h"

namespace hexapod {

/// NSGA-II's truncation: the best `count` of the pool, or all when there are fewer, front by front;
/// the front that no longer fits gives its most diverse members, of equals those with lower ids.
/// `diversity`: crowding (Deb et al. 2002) or genotypic (see nsga2.h). Survivors carry their
/// standing in the pool, and come in NSGA-II's order. One objective pair per individual.
std::vector<Individual> survivors(const std::vector<Individual>& pool,
                                  const std::vector<Objectives>& objectives, std::size_t count,
                                  const std::string& diversity);

}  // namespace hexapod
