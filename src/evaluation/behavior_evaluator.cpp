#include "evaluation/behavior_evaluator.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "simulation/reduced/batch_rollout.h"

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

BehaviorEvaluator::BehaviorEvaluator(std::shared_ptr<WorldPool> worlds,
                                     const BehaviorOptions& options,
                                     const std::atomic<bool>* cancelled)
    : worlds_(std::move(worlds)), options_(options), cancelled_(cancelled) {
  checkReturnIsSlowEnough(worlds_->robot(), options_);
}

std::vector<Outcome> BehaviorEvaluator::evaluate(const std::vector<Genome>& genomes) {
  std::vector<Outcome> outcomes(genomes.size());
  const std::size_t size = runsAtOnce(worlds_->engine());
  worlds_->forEach((genomes.size() + size - 1) / size, [&](World& world, std::size_t part) {
    if (cancelled_ && *cancelled_) throw EvaluationCancelled();
    const std::size_t begin = part * size, end = std::min(begin + size, genomes.size());
    std::vector<Behavior> behaviors;
    for (std::size_t i = begin; i < end; ++i) behaviors.push_back(behaviorOf(genomes[i]));
    std::vector<BatchRun> runs;
    for (const Behavior& behavior : behaviors) runs.push_back({&behavior, nullptr});
    const std::vector<Outcome> played = playEach(world, runs, options_.command_period_s);
    std::copy(played.begin(), played.end(), outcomes.data() + begin);
  });
  for (const Outcome& outcome : outcomes) count(outcome, counts_);
  return outcomes;
}

Behavior BehaviorEvaluator::behaviorOf(const Genome& genome) const {
  try {
    return Behavior(worlds_->robot(), canonical(genome), options_);
  } catch (const std::exception& error) {
    throw std::runtime_error("Genome " + toString(genome) +
                             " cannot be simulated: " + error.what());
  }
}

}  // namespace hexapod
