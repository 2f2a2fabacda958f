#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "execution/leg_doubts.h"
#include "execution/source_clock.h"
#include "robot/robot_description.h"

namespace hexapod {

/// What somebody told of the robot's body, and when it came.
struct ToldBelief {
  std::string publisher;
  std::string robot_id;
  std::vector<std::string> dead_joints;
  std::int64_t stamp_ns = 0;  ///< ROS time
  Arrival arrival;
  std::int64_t steady_now_ns = 0;
};

/// Which joints the executor may do without: those of legs that a person says are not there, and of
/// what is told on body_belief what may be believed.
///
/// One node tells, every second: for this robot, with joints of this robot, freshly stamped
/// (SourceClock), and no more than so many legs. While anything else comes, two nodes tell, or
/// nobody does, nothing of it is. Not thread-safe.
class BeliefJudge {
 public:
  /// `max_dead_legs` 0: nothing that is told ever is. `dead_legs`: names of legs, with commas
  /// between them. Throws std::invalid_argument naming the word that is no leg, and those there
  /// are.
  BeliefJudge(const RobotDescription& robot, std::int64_t max_dead_legs,
              const std::string& dead_legs = "");

  void hear(const ToldBelief& told);

  /// What is to be tolerated now.
  JointTolerance tolerance(std::int64_t steady_now_ns) const;

  /// Why nothing is, as a sentence; empty when there is something to go by, or nobody tells.
  std::string problem(std::int64_t steady_now_ns) const;

 private:
  struct Heard {
    JointTolerance tolerance;
    std::string problem;
    std::int64_t steady_ns = 0;
    SourceClock clock;
  };

  std::string problemWith(const ToldBelief& told, SourceClock& clock,
                          JointTolerance& tolerance) const;
  std::vector<std::string> talking(std::int64_t steady_now_ns) const;

  std::string robot_id_;
  std::int64_t max_dead_legs_;
  std::map<std::string, std::size_t> joints_;
  std::vector<std::size_t> leg_of_joint_;
  std::vector<std::size_t> gone_;       // joints of legs that are not there
  std::map<std::string, Heard> heard_;  // the last word of each publisher
};

}  // namespace hexapod
