#include "robot/robot_description.h"

namespace hexapod {

std::size_t RobotDescription::jointCount() const {
  std::size_t count = 0;
  for (const Leg& leg : legs) count += leg.segments.size();
  return count;
}

std::vector<std::string> RobotDescription::jointNames() const {
  std::vector<std::string> names;
  for (const Joint* joint : joints()) names.push_back(joint->name);
  return names;
}

std::vector<const Joint*> RobotDescription::joints() const {
  std::vector<const Joint*> joints;
  for (const Leg& leg : legs) {
    for (const Segment& segment : leg.segments) joints.push_back(&segment.joint);
  }
  return joints;
}

std::vector<double> RobotDescription::neutralPose() const {
  std::vector<double> angles_rad;
  for (const Joint* joint : joints()) angles_rad.push_back(joint->neutral_rad);
  return angles_rad;
}

}  // namespace hexapod
