#include "execution/sitting_pose.h"

#include <algorithm>

namespace hexapod {

std::vector<double> sittingPose(const RobotDescription& robot, double signal) {
  std::vector<double> pose_rad = robot.neutralPose();
  const std::vector<const Joint*> joints = robot.joints();
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (joints[j]->signal != Signal::kSecond) continue;
    pose_rad[j] = std::clamp(pose_rad[j] + joints[j]->amplitude_rad * signal, joints[j]->lower_rad,
                             joints[j]->upper_rad);
  }
  return pose_rad;
}

}  // namespace hexapod
