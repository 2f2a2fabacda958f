#include "evaluation/behavior_evaluator.h"

namespace hexapod {
namespace {

void count(const Outcome& outcome, SimulationCounts& counts) {
  ++counts.simulations;
  switch (outcome.verdict) {
    case Verdict::kWalked:
      return;
    case Verdict::kFell:
      ++counts.fell;
      return;
    case Verdict::kSelfCollided:
      ++counts.self_collided;
      return;
    case Verdict::kDiverged:
      ++counts.diverged;
      return;
  }
}

}  // namespace

BehaviorEvaluator::BehaviorEvaluator(const std::shared_ptr<WorldPool>& worlds,
                                     const BehaviorOptions& options,
                                     const std::atomic<bool>* cancelled)
    : worlds_(worlds, {worlds->physics()}, options), cancelled_(cancelled) {}

std::vector<Outcome> BehaviorEvaluator::evaluate(const std::vector<Genome>& genomes) {
  std::vector<RobustWorlds::Run> runs(genomes.size());
  for (std::size_t i = 0; i < runs.size(); ++i) runs[i].genome = i;
  std::vector<Outcome> outcomes;
  for (const BatchResult& result : worlds_.play(genomes, runs, {nullptr, cancelled_})) {
    outcomes.push_back(result.outcome);
    count(result.outcome, counts_);
  }
  return outcomes;
}

}  // namespace hexapod
