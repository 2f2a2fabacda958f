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

/// What is asked of an evaluator: what a look says of each genome.
struct Questions {
  int look = 1;  ///< number of the look, 1: the first
  std::vector<Genome> genomes;
  std::vector<Outcome> previous;  ///< what the look before said of each; none for the first look
};

/// Tells what genomes do. All that evolution knows of the task.
///
/// It may do so in steps: a first look at every candidate, and costlier further ones at those few
/// that would enter the archive by what is known of them. All are deterministic: what they give
/// depends on the genome alone. Called from one thread; may use as many as they like inside.
class Evaluator {
 public:
  virtual ~Evaluator() = default;

  /// The first look: one outcome per genome, in the same order.
  virtual std::vector<Outcome> evaluate(const std::vector<Genome>& genomes) = 0;

  /// The number of the look that is final, >= 1.
  virtual int looks() const { return 1; }

  /// What look number `look`, 2 .. looks(), says of each genome, in the same order, given what the
  /// look before it said: `previous` has one outcome per genome.
  virtual std::vector<Outcome> lookAgain(int look, const std::vector<Genome>& genomes,
                                         const std::vector<Outcome>& previous) {
    static_cast<void>(look);
    static_cast<void>(genomes);
    return previous;
  }
};

/// The evaluator's answers: one outcome per genome, in the same order. Nobody is bothered with no
/// genomes.
inline std::vector<Outcome> answersOf(Evaluator& evaluator, const Questions& questions) {
  if (questions.genomes.empty()) return {};
  return questions.look == 1
             ? evaluator.evaluate(questions.genomes)
             : evaluator.lookAgain(questions.look, questions.genomes, questions.previous);
}

}  // namespace hexapod
