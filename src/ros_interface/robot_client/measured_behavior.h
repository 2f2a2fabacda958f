#pragma once

#include <ros/duration.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "ros_interface/robot_client/behavior_player.h"
#include "ros_interface/robot_client/pose_source.h"

namespace hexapod {

/// Who plays behaviours, who tells where the robot is, and how long it takes to come to rest.
struct RobotAccess {
  BehaviorPlayer& executor;
  const PoseSource& poses;
  ros::Duration settle;
};

/// What became of a behaviour.
struct MeasuredBehavior {
  std::optional<Pose2> start;    ///< base_footprint before it in the global frame, where known
  std::optional<Pose2> reached;  ///< after it; none when it was not played to its end
  std::uint32_t skipped = 0;     ///< of its commands; a problem
  std::string problem;           ///< a sentence, empty when it was played and measured
};

/// Has a behaviour played once the robot is ready, and measures where it begins and ends, at rest.
/// `begun`, if given, is called when it begins.
MeasuredBehavior playMeasured(const RobotAccess& robot, const BehaviorPlayer::Order& order,
                              const std::function<void(const MeasuredBehavior&)>& begun = nullptr);

}  // namespace hexapod
