#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <ros/time.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <string>

#include "geometry/pose2.h"
#include "ros_interface/planner/planner_node_options.h"

namespace hexapod {

/// A pose in the plane or a sentence that tells why there is none.
struct PoseReading {
  std::optional<Pose2> pose;
  std::string problem;  ///< empty when there is a pose
};

/// Where the robot stands and where goals are, through tf. Never hands out a pose that tf did not
/// give. Callable from any thread; waits block the caller only.
class PoseSource {
 public:
  explicit PoseSource(const PlannerNodeOptions& options);

  /// global_from_base, not older than pose_timeout_s. With `after`, waits (at most pose_timeout_s
  /// longer than that takes) for a pose stamped at or after it.
  PoseReading robotPose(const ros::Time& after = ros::Time(0)) const;

  /// A goal brought into the global frame; a stamp of 0 means the latest transform.
  PoseReading goalPose(const geometry_msgs::PoseStamped& goal) const;

 private:
  PlannerNodeOptions options_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
};

}  // namespace hexapod
