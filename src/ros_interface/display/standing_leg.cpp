#include "ros_interface/display/standing_leg.h"

#include "simulation/kinematics.h"

namespace hexapod {

std::vector<Eigen::Vector3d> standingLeg(const RobotDescription& robot, std::size_t leg) {
  const std::vector<Eigen::Isometry3d> poses = baseFromBodies(robot, robot.neutralPose());
  std::size_t body = 1;  // after the base
  for (std::size_t i = 0; i < leg; ++i) body += robot.legs[i].segments.size();
  std::vector<Eigen::Vector3d> joints;
  for (std::size_t k = 0; k < robot.legs[leg].segments.size(); ++k) {
    joints.push_back(poses[body + k].translation());
  }
  // The tip of the last segment is about twice as far as its middle.
  const Body& last = robot.legs[leg].segments.back().body;
  joints.emplace_back(poses[body + robot.legs[leg].segments.size() - 1] *
                      (2.0 * last.center_of_mass_m));
  return joints;
}

}  // namespace hexapod
