#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "gait/behavior.h"
#include "gait/outcome.h"
#include "simulation/physics.h"
#include "simulation/reduced/batch_stepper.h"
#include "simulation/reduced/run_queue.h"
#include "simulation/world.h"

namespace hexapod {

/// Physics in which runs may be played side by side, with the state that a restarted ReducedWorld
/// of them has.
struct BatchPhysics {
  Physics physics;
  WorldState settled;
};

/// How much a batch has had to do: a register steps all of its lanes, whether they have a run or
/// not.
struct LaneUse {
  std::int64_t register_steps = 0;
  std::int64_t lane_steps = 0;  ///< of lanes that had a run
};

/// Plays many behaviours at once, one per lane of a SIMD register, in the reduced engine.
///
/// Results are those of play() with a ReducedWorld of the same robot and physics, bit for bit,
/// whatever the instruction set and whoever the neighbours in the register are, of other physics
/// and other steps too. A lane whose behaviour has ended, or failed, takes up the next one at once.
/// One per thread: a batch is used by one thread at a time.
class BatchRollout {
 public:
  /// Runs of one physics. Throws as ReducedWorld does; std::invalid_argument when the machine lacks
  /// `instructions`.
  BatchRollout(const RobotDescription& robot, const Physics& physics,
               reduced::InstructionSet instructions = reduced::bestInstructionSet());
  /// Runs of several physics; nothing is settled. Throws std::invalid_argument, too, when there are
  /// none, or some whose legs are in other states than those of the first.
  BatchRollout(const RobotDescription& robot, std::vector<BatchPhysics> physics,
               reduced::InstructionSet instructions = reduced::bestInstructionSet());
  ~BatchRollout();

  /// Robots per register: a multiple of it in `runs` leaves none idle, many more hide the rest.
  int lanes() const;

  /// The state that runs of the first physics start from when they name none.
  const WorldState& settled() const { return physics_.front().settled; }

  /// One result per run, in the same order. What `runs` points to is used during the call only.
  /// Throws std::invalid_argument when the command period is not a multiple of a step or a start
  /// state does not fit the robot.
  std::vector<BatchResult> play(const std::vector<BatchRun>& runs, double command_period_s);

  /// Plays runs of the queue until none is left; other threads' batches may do so, too. Throws as
  /// above, with runs that nobody will play left in the queue.
  void play(RunQueue& queue, double command_period_s);

  /// Since construction.
  const LaneUse& use() const { return use_; }

 private:
  std::vector<BatchPhysics> physics_;
  HeldJoints held_;
  std::unique_ptr<const reduced::ReducedModel> model_;
  std::vector<reduced::Conditions<double>> conditions_;  // one per physics
  std::unique_ptr<reduced::Stepper> stepper_;
  LaneUse use_;
};

/// Plays every run from its own start in the given world, or beside it: in batches where it is a
/// ReducedWorld, one after the other elsewhere. Outcomes are those of play() after restart() or
/// restore(); the world's state afterwards is any. Throws as play() and restore() do.
std::vector<Outcome> playEach(World& world, const std::vector<BatchRun>& runs,
                              double command_period_s);

/// How many runs playEach() should get at a time to make the best of an engine.
std::size_t runsAtOnce(Engine engine);

}  // namespace hexapod
