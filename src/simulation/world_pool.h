#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "robot/robot_description.h"
#include "simulation/world.h"

namespace hexapod {

/// One World per thread, all alike, kept for as long as the pool lives.
///
/// A pool is used by one thread at a time. Inside, forEach() spreads work over its own oneTBB
/// arena.
class WorldPool {
 public:
  /// `threads` 0: as many as the machine has cores. The description is copied in.
  /// Throws std::invalid_argument when `threads` is negative or beyond 1024, or a physics value is
  /// out of range.
  WorldPool(Engine engine, const RobotDescription& robot, const Physics& physics, int threads = 0);
  ~WorldPool();
  WorldPool(const WorldPool&) = delete;
  WorldPool& operator=(const WorldPool&) = delete;

  Engine engine() const { return engine_; }
  const RobotDescription& robot() const { return robot_; }
  const Physics& physics() const { return physics_; }
  int threads() const;

  /// Calls work(world, i) once for every i < count, in any order, on several threads at once;
  /// returns when all are done. The world is left by earlier work as it is: restart() or restore()
  /// it first. Worlds are built when a thread first needs one. When a call throws, those not yet
  /// begun are given up and the exception is passed on.
  void forEach(std::size_t count, const std::function<void(World&, std::size_t)>& work);

 private:
  class Threads;

  Engine engine_;
  RobotDescription robot_;
  Physics physics_;
  std::unique_ptr<Threads> threads_;
};

}  // namespace hexapod
