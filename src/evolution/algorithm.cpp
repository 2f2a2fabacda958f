#include "evolution/algorithm.h"

namespace hexapod {

void advance(Algorithm& algorithm, Evaluator& evaluator, std::int64_t most_candidates) {
  const std::int64_t complete = algorithm.counters().generations;
  while (algorithm.counters().generations == complete) {
    algorithm.tell(answersOf(evaluator, algorithm.ask(most_candidates)));
  }
}

}  // namespace hexapod
