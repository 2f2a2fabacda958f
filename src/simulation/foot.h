#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "robot/robot_description.h"
#include "simulation/recording.h"

namespace hexapod {

/// Where a leg reaches down to.
struct Foot {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< lower end of its last shape's middle line
  double height_m = 0.0;                            ///< of that shape's lowest point
};

/// The feet of a robot at a pose of its base and joint angles, in leg order.
std::vector<Foot> feetOf(const RobotDescription& robot, const RecordedPose& pose);

/// Highest foot that is still said to stand on a level floor [m].
double standingFootHeight(const RobotDescription& robot);

}  // namespace hexapod
