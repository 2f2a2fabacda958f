#pragma once

#include <atomic>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "gait/behavior.h"
#include "simulation/reduced/batch_rollout.h"
#include "simulation/world_pool.h"

namespace hexapod {

/// The robot of a pool under several physics, on all threads of the pool.
///
/// Each thread builds its worlds when it first needs them. Results are those of play() in the
/// pool's engine, whatever the number of threads. Used by one thread at a time.
class RobustWorlds {
 public:
  /// One behaviour to play, under which physics, and from which state; nullptr: the settled stand.
  struct Run {
    std::size_t physics = 0;
    const Behavior* behavior = nullptr;
    const WorldState* start = nullptr;
  };

  /// Throws std::invalid_argument when a physics value is out of range or a step does not divide
  /// the command period.
  RobustWorlds(std::shared_ptr<WorldPool> pool, std::vector<Physics> physics,
               double command_period_s);
  ~RobustWorlds();

  const RobotDescription& robot() const { return pool_->robot(); }
  const std::vector<Physics>& physics() const { return physics_; }

  /// One result per run, in the same order. Throws EvaluationCancelled soon after `cancelled`, if
  /// given, turns true.
  std::vector<BatchResult> play(const std::vector<Run>& runs,
                                const std::atomic<bool>* cancelled = nullptr);

 private:
  class Simulator;

  Simulator& simulatorOf(const World& world, std::size_t physics);

  std::shared_ptr<WorldPool> pool_;
  std::vector<Physics> physics_;
  double command_period_s_;
  std::mutex mutex_;  // of simulators_
  std::map<std::pair<const World*, std::size_t>, std::unique_ptr<Simulator>> simulators_;
};

}  // namespace hexapod
