#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "gait/behavior.h"
#include "planning/foresight.h"
#include "robot/robot_description.h"
#include "simulation/world.h"

namespace hexapod {

/// Where a behaviour led in the mind, and how.
struct Imagined {
  Verdict verdict =
      Verdict::kDiverged;          ///< its first failure; it is played to the end all the same
  Pose2 start_from_end;            ///< not finite when it diverged
  WorldState end;                  ///< footprint at the origin, heading 0
  std::vector<JointRange> joints;  ///< how far each joint moved, in joint order; if asked for
};

/// Plays behaviours in bodies that the robot may have, from the state it may be in.
///
/// Spreads work over its threads; results are the same for any number of them. Immutable; may be
/// shared by threads.
class Imagination {
 public:
  struct Question {
    Physics body;
    const WorldState* start = nullptr;
  };
  enum class Joints { kIgnored, kWatched };

  /// `threads` 0: as many as the machine has cores.
  Imagination(const RobotDescription& robot, const BehaviorOptions& behavior, Engine engine,
              int threads);
  ~Imagination();

  const RobotDescription& robot() const { return robot_; }

  /// A state moved over the floor: footprint at the origin, with the given heading.
  WorldState turned(const WorldState& state, double heading_rad) const;

  /// The settled stand of a body; nothing when it does not stand.
  std::vector<std::optional<WorldState>> stands(const std::vector<Physics>& bodies) const;

  /// One behaviour in several bodies. Where their joints do not matter, bodies with the same legs
  /// are played side by side, which is several times as fast.
  std::vector<Imagined> play(const Genome& genome, const std::vector<Question>& questions,
                             Joints joints = Joints::kWatched) const;

  /// Several behaviours in one body, each from `start`: as play() of simulation, stopped at the
  /// first failure.
  std::vector<Outcome> playAll(const std::vector<Genome>& genomes, const Question& question) const;

 private:
  class Threads;

  template <typename Work>
  void forEach(std::size_t count, const Work& work) const;
  Imagined playOne(const Behavior& behavior, const Question& question) const;
  Pose2 way(const WorldState& start, const WorldState& end) const;
  void playAbreast(const Behavior& behavior, const std::vector<Question>& questions,
                   const std::vector<std::size_t>& some, std::vector<Imagined>& answers) const;

  RobotDescription robot_;
  BehaviorOptions behavior_;
  BehaviorMaker maker_;  // of robot_
  Engine engine_;
  std::unique_ptr<Threads> threads_;
};

}  // namespace hexapod
