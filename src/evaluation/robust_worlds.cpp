#include "evaluation/robust_worlds.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "evolution/evaluator.h"
#include "simulation/physics.h"
#include "simulation/rollout.h"

namespace hexapod {

RobustWorlds::RobustWorlds(std::shared_ptr<WorldPool> pool, std::vector<Physics> physics,
                           const BehaviorOptions& behavior)
    : pool_(std::move(pool)),
      physics_(std::move(physics)),
      behavior_(behavior),
      maker_(pool_->robot(), behavior) {
  for (const Physics& one : physics_) {
    checkPhysics(one);
    stepsPerCommand(behavior_.command_period_s, one.step_s);
  }
}

RobustWorlds::~RobustWorlds() = default;

std::vector<BatchResult> RobustWorlds::play(const std::vector<Genome>& genomes,
                                            const std::vector<Run>& runs, const PlayHooks& hooks) {
  Behaviors behaviors = behaviorsOf(genomes);
  // What takes longest is begun first, so that all threads end at about the same time.
  std::vector<std::size_t> order(runs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return physics_[runs[a].physics].step_s < physics_[runs[b].physics].step_s;
  });
  std::vector<BatchRun> ordered;
  for (const std::size_t i : order) {
    ordered.push_back({behaviors[runs[i].genome].get(), runs[i].start, runs[i].physics});
  }
  std::function<void(std::size_t)> ended;
  if (hooks.progress) ended = [&](std::size_t done) { hooks.progress(done, runs.size()); };
  RunQueue queue(ordered, ended, hooks.cancelled);
  if (pool_->engine() == Engine::kReduced) {
    playInBatches(queue);
  } else {
    playOneByOne(queue);
  }
  if (hooks.cancelled != nullptr && *hooks.cancelled) throw EvaluationCancelled();
  // Hundreds of small pieces each: left to the end, one thread would put them away while others
  // wait.
  pool_->forEach(behaviors.size(), [&](World& /*world*/, std::size_t i) { behaviors[i].reset(); });
  std::vector<BatchResult> results(runs.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    results[order[k]] = std::move(queue.results()[k]);
  }
  return results;
}

RobustWorlds::Behaviors RobustWorlds::behaviorsOf(const std::vector<Genome>& genomes) const {
  Behaviors behaviors(genomes.size());
  pool_->forEach(genomes.size(), [&](World& /*world*/, std::size_t i) {
    try {
      behaviors[i] = std::make_unique<const Behavior>(maker_.make(genomes[i]));
    } catch (const std::invalid_argument& error) {
      throw std::runtime_error("Genome " + toString(genomes[i]) +
                               " cannot be simulated: " + error.what());
    }
  });
  return behaviors;
}

void RobustWorlds::settle() {
  if (!settled_.empty()) return;
  std::vector<BatchPhysics> settled(physics_.size());
  pool_->forEach(physics_.size(), [&](World& /*world*/, std::size_t i) {
    settled[i] = {physics_[i], makeWorld(pool_->engine(), robot(), physics_[i])->state()};
  });
  settled_ = std::move(settled);
}

void RobustWorlds::playInBatches(RunQueue& queue) {
  if (queue.runs().empty()) return;
  settle();
  const std::size_t lanes = runsAtOnce(pool_->engine());
  const std::size_t batches = std::min((queue.runs().size() + lanes - 1) / lanes,
                                       static_cast<std::size_t>(pool_->threads()));
  pool_->forEach(batches, [&](World& world, std::size_t) {
    batchOf(world).play(queue, behavior_.command_period_s);
  });
}

void RobustWorlds::playOneByOne(RunQueue& queue) {
  pool_->forEach(queue.runs().size(), [&](World& of_thread, std::size_t) {
    const std::optional<std::size_t> number = queue.take();
    if (!number) return;
    const BatchRun& run = queue.runs()[*number];
    World& world = worldOf(of_thread, run.physics);
    if (run.start != nullptr) {
      world.restore(*run.start);
    } else {
      world.restart();
    }
    const Outcome outcome = hexapod::play(world, *run.behavior, behavior_.command_period_s);
    queue.finish(*number, {outcome, world.state()});
  });
}

BatchRollout& RobustWorlds::batchOf(const World& world) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::unique_ptr<BatchRollout>& batch = batches_[&world];
  if (!batch) batch = std::make_unique<BatchRollout>(robot(), settled_);
  return *batch;
}

World& RobustWorlds::worldOf(const World& world, std::size_t physics) {
  std::unique_ptr<World>* own = nullptr;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    own = &worlds_[{&world, physics}];
  }
  // Settling takes a while; nobody else asks for this one.
  if (!*own) *own = makeWorld(pool_->engine(), robot(), physics_[physics]);
  return **own;
}

LaneUse RobustWorlds::use() const {
  LaneUse sum;
  for (const auto& [world, batch] : batches_) {
    sum.register_steps += batch->use().register_steps;
    sum.lane_steps += batch->use().lane_steps;
  }
  return sum;
}

}  // namespace hexapod
