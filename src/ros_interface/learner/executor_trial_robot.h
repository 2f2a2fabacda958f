#pragma once

#include <ros/node_handle.h>
#include <ros/wall_timer.h>
#include <tf2/buffer_core.h>

#include <functional>

#include "ros_interface/common/clock.h"
#include "ros_interface/robot_client/executor_topics.h"
#include "ros_interface/robot_client/tf_pose_source.h"
#include "ros_interface/robot_client/transform_ears.h"
#include "transferability/trial_robot.h"

namespace hexapod {

/// The robot of the running session: its executor plays, tf tells where it ends. A robot that is
/// not armed, or whose pose is not known, is not moved; a behaviour some of whose commands were
/// skipped is played again, and was not played where three tries were like that. The first trial
/// waits for the executor's state, which comes once a second.
class ExecutorTrialRobot : public TrialRobot {
 public:
  /// `leaves`: breaks a trial off. The clock must outlive it.
  ExecutorTrialRobot(ros::NodeHandle& node, const PoseOptions& options, const Clock& clock,
                     std::function<bool()> leaves);

  Result play(const Genome& genome) override;

 private:
  void awaitState();

  const PoseOptions options_;
  const Clock& clock_;
  const std::function<bool()> leaves_;
  ExecutorTopics executor_;
  tf2::BufferCore buffer_;
  TransformEars ears_;
  TfPoseSource poses_;
  bool awaited_ = false;
  ros::WallTimer watch_;  // of the pose, as that wants to be watched
};

}  // namespace hexapod
