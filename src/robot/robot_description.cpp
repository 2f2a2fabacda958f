#include "robot/robot_description.h"

#include <algorithm>

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

std::size_t RobotDescription::signalsPerLeg() const {
  int highest = static_cast<int>(Signal::kSecond);
  for (const Leg& leg : legs) {
    for (const Segment& segment : leg.segments) {
      highest = std::max(highest, static_cast<int>(segment.joint.signal));
    }
  }
  return static_cast<std::size_t>(highest);
}

std::vector<double> RobotDescription::neutralPose() const {
  std::vector<double> angles_rad;
  for (const Joint* joint : joints()) angles_rad.push_back(joint->neutral_rad);
  return angles_rad;
}

}  // namespace hexapod
