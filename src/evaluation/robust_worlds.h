#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "gait/behavior.h"
#include "simulation/reduced/batch_rollout.h"
#include "simulation/world_pool.h"

namespace hexapod {

/// What a caller may watch and stop many runs with; both may be left empty.
struct PlayHooks {
  /// Called with the runs done and their total, by any of the pool's threads, one at a time.
  std::function<void(std::size_t, std::size_t)> progress;
  /// Once it turns true, no run is begun any more.
  const std::atomic<bool>* cancelled = nullptr;
};

/// The robot of a pool under one or several physics, on all threads of the pool: whatever plays
/// more than a few behaviours plays them here.
///
/// The runs of a call are one queue, the longest first, from which every lane of every thread takes
/// the next one when it is free, whatever its physics and its start. Results are those of play() in
/// the pool's engine, whatever the number of threads. Used by one thread at a time.
class RobustWorlds {
 public:
  /// The behaviour of which genome is played, under which physics, and from which state; nullptr:
  /// the settled stand.
  struct Run {
    std::size_t genome = 0;
    std::size_t physics = 0;
    const WorldState* start = nullptr;
  };

  /// Throws std::invalid_argument when options do not fit the robot, a physics value is out of
  /// range or a step does not divide the command period. All physics have the same leg states.
  RobustWorlds(std::shared_ptr<WorldPool> pool, std::vector<Physics> physics,
               const BehaviorOptions& behavior);
  ~RobustWorlds();

  const RobotDescription& robot() const { return pool_->robot(); }
  const std::vector<Physics>& physics() const { return physics_; }

  /// One result per run, in the same order. Throws
  /// EvaluationCancelled within one simulated behaviour of `cancelled` turning true, and
  /// std::runtime_error naming a genome that cannot be simulated at all.
  std::vector<BatchResult> play(const std::vector<Genome>& genomes, const std::vector<Run>& runs,
                                const PlayHooks& hooks = {});

  /// How full the registers were so far; of the engine reduced only.
  LaneUse use() const;

 private:
  using Behaviors = std::vector<std::unique_ptr<const Behavior>>;

  Behaviors behaviorsOf(const std::vector<Genome>& genomes) const;
  void settle();
  void playInBatches(RunQueue& queue);
  void playOneByOne(RunQueue& queue);
  BatchRollout& batchOf(const World& world);
  World& worldOf(const World& world, std::size_t physics);

  std::shared_ptr<WorldPool> pool_;
  std::vector<Physics> physics_;
  BehaviorOptions behavior_;
  BehaviorMaker maker_;
  std::vector<BatchPhysics> settled_;                              // empty until the first call
  std::mutex mutex_;                                               // of what follows
  std::map<const World*, std::unique_ptr<BatchRollout>> batches_;  // by the pool's worlds
  std::map<std::pair<const World*, std::size_t>, std::unique_ptr<World>> worlds_;
};

}  // namespace hexapod
