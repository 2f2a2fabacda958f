#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/JointState.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "common/random.h"
#include "geometry/pose2.h"
#include "ros_interface/common/names.h"
#include "ros_interface/simulated_robot/disturbance.h"
#include "simulation/world.h"

namespace hexapod {

/// Where a robot is, as its driver tells it.
struct RobotReport {
  sensor_msgs::JointState joints;
  nav_msgs::Odometry odometry;
  std::vector<geometry_msgs::TransformStamped> transforms;  ///< odom -> base_footprint -> base
};

/// What the frames of a robot are called.
struct RobotFrames {
  std::string odom_frame = names::kOdomFrame;
  std::string base_frame = names::kFootprintFrame;
  /// With a slash in front of the base link's name, as robot_state_publisher puts it; "": nothing.
  std::string tf_prefix;
};

/// Makes reports of a simulated robot. base_footprint is the projection of the base on the floor
/// with its heading (REP-120); height, roll and pitch are in base_footprint -> base. Velocities are
/// those since the report before, in the footprint's frame; zero in the first one. Knows no wire;
/// used by one thread.
class RobotObserver {
 public:
  explicit RobotObserver(const RobotDescription& robot, const RobotFrames& frames = {});

  /// The world's state at `stamp`, until the next call; nullptr where it is not finite.
  const RobotReport* observe(const World& world, const ros::Time& stamp);

  /// From now on reported joint angles are noisy, and joints of missing legs are left out: there is
  /// nothing that could report them.
  void disturb(const RobotDescription& robot, const Disturbance& disturbance);

  /// The next velocity is not taken from the pose before (the robot was put elsewhere).
  void forgetMotion() { last_.reset(); }

 private:
  struct Footing {
    Pose2 odom_from_footprint;
    ros::Time stamp;
  };

  void fillJoints(const World& world);
  void fillOdometry(const Pose2& odom_from_footprint, const ros::Time& stamp);
  void fillTransforms(const Eigen::Isometry3d& world_from_base, const Pose2& footprint,
                      const ros::Time& stamp);

  RobotFrames frames_;
  std::string base_link_;
  Eigen::Isometry3d base_from_link_;  // they differ where forward is not x of the link
  std::vector<std::string> joint_names_;
  std::vector<bool> reported_;  // per joint
  double noise_rad_ = 0.0;
  Random random_{2};
  std::vector<double> angles_rad_;
  RobotReport report_;
  std::optional<Footing> last_;
};

}  // namespace hexapod
