#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "common/random.h"
#include "gait/genome.h"

namespace hexapod {

/// Three objectives, all to be maximised. One in which all individuals are equal plays no part.
using Objectives = std::array<double, 3>;

/// Indices of the members of one Pareto front.
using Front = std::vector<std::size_t>;

/// Standing of an individual in NSGA-II's order.
struct Standing {
  std::size_t rank = 0;    ///< number of its front, 0: non-dominated
  double diversity = 0.0;  ///< within its front, larger is better
};

/// True when a is at least as good in all objectives and better in one.
bool dominates(const Objectives& a, const Objectives& b);

/// Non-dominated sorting (Deb et al. 2002): the fronts from best to worst, each sorted by index.
/// Fronts are looked for by bisection (Zhang et al. 2015). Objectives must not be NaN.
std::vector<Front> nonDominatedFronts(const std::vector<Objectives>& objectives);

/// Crowding distance (Deb et al. 2002) of each member of a front, in its order: sum over objectives
/// of the normalised gap between its two neighbours; infinite at the ends. An objective in which
/// all members are equal counts nothing.
std::vector<double> crowdingDistances(const std::vector<Objectives>& objectives,
                                      const Front& front);

/// Genotypic diversity of each member of a front, in its order: mean number of genes in which it
/// differs from the other members. 0 when it is alone. All genomes have one length.
std::vector<double> genotypicDiversities(const std::vector<Genome>& genomes, const Front& front);

/// NSGA-II's order: lower rank first, then larger diversity.
bool isBetter(const Standing& a, const Standing& b);

/// Binary tournament with replacement: index of the better of two drawn uniformly, the first drawn
/// when they are equal. `standings` must not be empty.
std::size_t tournament(const std::vector<Standing>& standings, Random& random);

}  // namespace hexapod
