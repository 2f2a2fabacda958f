#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "gait/behavior.h"
#include "gait/outcome.h"
#include "simulation/physics.h"
#include "simulation/reduced/batch_stepper.h"
#include "simulation/world.h"

namespace hexapod {

/// One behaviour to play, and the state it starts from; nullptr: the settled stand.
struct BatchRun {
  const Behavior* behavior = nullptr;
  const WorldState* start = nullptr;
};

/// How it ended, and the state it left the robot in.
struct BatchResult {
  Outcome outcome;
  WorldState end;
};

/// Plays many behaviours at once, one per lane of a SIMD register, in the reduced engine.
///
/// Results are those of play() with a ReducedWorld of the same robot and physics, bit for bit,
/// whatever the instruction set and whoever the neighbours in the register are. A lane whose
/// behaviour has ended, or failed, takes up the next one at once. One per thread: a batch is used
/// by one thread at a time.
class BatchRollout {
 public:
  /// Throws as ReducedWorld does; std::invalid_argument when the machine lacks `instructions`.
  BatchRollout(const RobotDescription& robot, const Physics& physics,
               reduced::InstructionSet instructions = reduced::bestInstructionSet());
  /// The same without settling: `settled` is the state of a restarted ReducedWorld.
  BatchRollout(const RobotDescription& robot, const Physics& physics, const WorldState& settled,
               reduced::InstructionSet instructions = reduced::bestInstructionSet());
  ~BatchRollout();

  /// Robots per register: a multiple of it in `runs` leaves none idle, many more hide the rest.
  int lanes() const;

  /// The state that runs start from when they name none: as World::restart().
  const WorldState& settled() const { return settled_; }

  /// One result per run, in the same order. What `runs` points to is used during the call only.
  /// Throws std::invalid_argument when the command period is not a multiple of the step or a start
  /// state does not fit the robot.
  std::vector<BatchResult> play(const std::vector<BatchRun>& runs, double command_period_s);

 private:
  Physics physics_;
  HeldJoints held_;
  std::unique_ptr<const reduced::ReducedModel> model_;
  std::unique_ptr<reduced::Stepper> stepper_;
  WorldState settled_;
};

/// Plays every run from its own start in the given world, or beside it: in batches where it is a
/// ReducedWorld, one after the other elsewhere. Outcomes are those of play() after restart() or
/// restore(); the world's state afterwards is any. Throws as play() and restore() do.
std::vector<Outcome> playEach(World& world, const std::vector<BatchRun>& runs,
                              double command_period_s);

/// How many runs playEach() should get at a time to make the best of an engine.
std::size_t runsAtOnce(Engine engine);

}  // namespace hexapod
