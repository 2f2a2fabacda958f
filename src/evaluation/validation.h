#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "evaluation/robust_worlds.h"
#include "gait/genome.h"
#include "gait/outcome.h"
#include "repertoire/entry.h"
#include "simulation/world_pool.h"

namespace hexapod {

/// How often and from where every genome is executed.
struct ValidationOptions {
  std::int64_t trials = 8;         ///< executions of each genome, 1 .. start_states
  std::int64_t start_states = 16;  ///< states after random predecessors, shared by all genomes
  std::uint64_t seed = 1;
};

/// Executes every genome after random predecessors and tells what a planner must expect of it.
///
/// Chains of two or three behaviours drawn from the list itself, each from the settled stand, give
/// `start_states` states of the world, in which robots are that have just walked. (A predecessor
/// that fails is taken back and another one drawn.) Every genome is then played from `trials`
/// different ones of them, its own choice, so that n genomes cost n * trials simulations. Same
/// options and genomes, same result, whatever the number of threads.
///
/// Returns one Execution per genome, in order; the hooks are told of executions. Throws
/// std::invalid_argument when an option is out of range, EvaluationCancelled as RobustWorlds does.
std::vector<Execution> validate(const std::shared_ptr<WorldPool>& worlds,
                                const BehaviorOptions& behavior, const std::vector<Genome>& genomes,
                                const ValidationOptions& options, const PlayHooks& hooks = {});

/// Mean and spread over the outcomes that walked, falls over the others. A mean of headings is that
/// of their unit vectors. Without any that walked, mean and spread are 0.
Execution summarize(const std::vector<Outcome>& outcomes);

}  // namespace hexapod
