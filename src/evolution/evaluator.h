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
class Evaluator {
 public:
  virtual ~Evaluator() = default;

  /// One outcome per genome, in the same order. Deterministic: an outcome depends on its genome
  /// alone. Called from one thread; may use as many as it likes inside.
  virtual std::vector<Outcome> evaluate(const std::vector<Genome>& genomes) = 0;
};

}  // namespace hexapod
