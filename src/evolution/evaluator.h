#pragma once

#include <stdexcept>
#include <vector>

#include "gait/genome.h"
#include "gait/outcome.h"

namespace hexapod {

/// Thrown by an evaluator that was told to give up a batch.
class EvaluationCancelled : public std::runtime_error {
 public:
  EvaluationCancelled() : std::runtime_error("The evaluation was cancelled.") {}
};

/// Tells what genomes do. All that evolution knows of the task.
///
/// It may do so in two steps: a first look at every candidate, and a costlier second one at those
/// few that would enter the archive. Both are deterministic: what they give depends on the genome
/// alone. Called from one thread; may use as many as they like inside.
class Evaluator {
 public:
  virtual ~Evaluator() = default;

  /// The first look: one outcome per genome, in the same order.
  virtual std::vector<Outcome> evaluate(const std::vector<Genome>& genomes) = 0;

  /// False when the first look is final.
  virtual bool looksTwice() const { return false; }

  /// The final outcome of each genome, in the same order, given what evaluate() said of it: `first`
  /// has one outcome per genome.
  virtual std::vector<Outcome> lookAgain(const std::vector<Genome>& genomes,
                                         const std::vector<Outcome>& first) {
    static_cast<void>(genomes);
    return first;
  }
};

}  // namespace hexapod
