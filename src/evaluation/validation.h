#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "gait/behavior.h"
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

/// What a caller may watch and stop a validation with; both may be left empty.
struct ValidationHooks {
  /// Called with the genomes done and their total, by any of the pool's threads, one at a time.
  std::function<void(std::size_t, std::size_t)> progress;
  /// Genomes not begun when it turns true are left out.
  const std::atomic<bool>* cancelled = nullptr;
};

/// Executes every genome after random predecessors and tells what a planner must expect of it.
///
/// Chains of two or three behaviours drawn from the list itself, each from the settled stand, give
/// `start_states` states of the world, in which robots are that have just walked. (A predecessor
/// that fails is taken back and another one drawn.) Every genome is then played from `trials`
/// different ones of them, its own choice, so that n genomes cost n * trials simulations. Same
/// options and genomes, same result, whatever the number of threads. Genomes are simulated in their
/// canonical() form.
///
/// Returns one Execution per genome, in order; one that was cancelled has trials = 0.
/// Throws std::invalid_argument when an option is out of range.
std::vector<Execution> validate(WorldPool& worlds, const BehaviorOptions& behavior,
                                const std::vector<Genome>& genomes,
                                const ValidationOptions& options,
                                const ValidationHooks& hooks = {});

/// Mean and spread over the outcomes that walked, falls over the others. A mean of headings is that
/// of their unit vectors. Without any that walked, mean and spread are 0.
Execution summarize(const std::vector<Outcome>& outcomes);

}  // namespace hexapod
