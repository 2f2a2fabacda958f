#include "simulation/behavior_evaluator.h"

#include <stdexcept>
#include <utility>

#include "simulation/rollout.h"

namespace hexapod {
namespace {

Outcome playFromStand(World& world, const Genome& genome, const BehaviorOptions& options) {
  try {
    const Behavior behavior(world.robot(), canonical(genome), options);
    world.restart();
    return play(world, behavior, options.command_period_s);
  } catch (const std::exception& error) {
    throw std::runtime_error("Genome " + toString(genome) +
                             " cannot be simulated: " + error.what());
  }
}

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
  worlds_->forEach(genomes.size(), [&](World& world, std::size_t i) {
    if (cancelled_ && *cancelled_) throw EvaluationCancelled();
    outcomes[i] = playFromStand(world, genomes[i], options_);
  });
  for (const Outcome& outcome : outcomes) count(outcome, counts_);
  return outcomes;
}

}  // namespace hexapod
