#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "evolution/evaluator.h"
#include "evolution/individual.h"
#include "repertoire/entry.h"

namespace hexapod {

/// An algorithm that searches for controllers by ask and tell: it asks what genomes do, and is
/// told.
///
/// It works in generations. A generation asks once about its candidates and, where the task has
/// further looks (see Evaluator), once more for each look at which some candidate is still
/// promising. Nothing has changed until the last answer of a generation is in: entries, counters
/// and state are those after the last generation that was completed.
///
/// Deterministic: same options, task, generator and answers, same entries. Used by one thread.
class Algorithm {
 public:
  virtual ~Algorithm() = default;

  /// What it wants to know now. Begins a generation of as many candidates as the algorithm's
  /// options say, or `most_candidates` (>= 1) if that is fewer, so that a budget can be met
  /// exactly. Within a generation, and when asked again before it was told, `most_candidates` plays
  /// no part. Valid until the next call. Throws std::invalid_argument for fewer candidates than 1.
  virtual const Questions& ask(
      std::int64_t most_candidates = std::numeric_limits<std::int64_t>::max()) = 0;

  /// The answers: one outcome per genome that was asked about, in the same order. An outcome whose
  /// numbers are not finite, or whose cost is negative, counts as diverged. Throws
  /// std::invalid_argument, and goes on waiting, when there are more or fewer answers than
  /// questions, or when nothing was asked.
  virtual void tell(const std::vector<Outcome>& outcomes) = 0;

  /// The controllers found so far: the algorithm's archive. Ids are unique.
  virtual const std::vector<Entry>& entries() const = 0;

  virtual const EvolutionCounters& counters() const = 0;
};

/// One generation: asks and tells until it is complete. When the evaluator throws, so does this,
/// and the generation is still under way: the next call goes on with the questions that are open.
void advance(Algorithm& algorithm, Evaluator& evaluator,
             std::int64_t most_candidates = std::numeric_limits<std::int64_t>::max());

}  // namespace hexapod
