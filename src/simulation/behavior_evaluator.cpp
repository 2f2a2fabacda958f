#include "simulation/behavior_evaluator.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "simulation/rollout.h"

namespace hexapod {
namespace {

[[noreturn]] void throwCannotSimulate(const Genome& genome, const std::exception& error) {
  throw std::runtime_error("Genome " + toString(genome) + " cannot be simulated: " + error.what());
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
  if (worlds_->engine() == Engine::kReduced) {
    playInBatches(genomes, outcomes);
  } else {
    playOneByOne(genomes, outcomes);
  }
  for (const Outcome& outcome : outcomes) count(outcome, counts_);
  return outcomes;
}

void BehaviorEvaluator::playOneByOne(const std::vector<Genome>& genomes,
                                     std::vector<Outcome>& outcomes) {
  worlds_->forEach(genomes.size(), [&](World& world, std::size_t i) {
    checkCancelled();
    const Behavior behavior = behaviorOf(genomes[i]);
    try {
      world.restart();
      outcomes[i] = play(world, behavior, options_.command_period_s);
    } catch (const std::exception& error) {
      throwCannotSimulate(genomes[i], error);
    }
  });
}

void BehaviorEvaluator::playInBatches(const std::vector<Genome>& genomes,
                                      std::vector<Outcome>& outcomes) {
  const std::size_t size = reduced::lanes(reduced::bestInstructionSet());
  worlds_->forEach((genomes.size() + size - 1) / size, [&](World& world, std::size_t part) {
    checkCancelled();
    const std::size_t begin = part * size;
    const std::size_t end = std::min(begin + size, genomes.size());
    std::vector<Behavior> behaviors;
    for (std::size_t i = begin; i < end; ++i) behaviors.push_back(behaviorOf(genomes[i]));
    std::vector<BatchRun> runs;
    for (const Behavior& behavior : behaviors) runs.push_back({&behavior, nullptr});
    const std::vector<BatchResult> results = batchOf(world).play(runs, options_.command_period_s);
    for (std::size_t i = begin; i < end; ++i) outcomes[i] = results[i - begin].outcome;
  });
}

Behavior BehaviorEvaluator::behaviorOf(const Genome& genome) const {
  try {
    return Behavior(worlds_->robot(), canonical(genome), options_);
  } catch (const std::exception& error) {
    throwCannotSimulate(genome, error);
  }
}

BatchRollout& BehaviorEvaluator::batchOf(const World& world) {
  const std::lock_guard<std::mutex> lock(batches_mutex_);
  std::unique_ptr<BatchRollout>& batch = batches_[&world];
  if (!batch) batch = std::make_unique<BatchRollout>(world.robot(), world.physics());
  return *batch;
}

void BehaviorEvaluator::checkCancelled() const {
  if (cancelled_ && *cancelled_) throw EvaluationCancelled();
}

}  // namespace hexapod
