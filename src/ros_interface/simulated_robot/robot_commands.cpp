#include "ros_interface/simulated_robot/robot_commands.h"

#include "ros_interface/common/clock.h"

namespace hexapod {
namespace {

// Limits that went through text.
constexpr double kLimitSlack_rad = 1e-6;
// A longer pause between two commands is no stream.
constexpr std::int64_t kLongestPeriod_ns = 200'000'000;

}  // namespace

RobotCommands::RobotCommands(const RobotDescription& robot, std::int64_t latency_ns)
    : matcher_(robot.jointNames()), schedule_(latency_ns) {
  for (const Joint* joint : robot.joints()) joints_.push_back(*joint);
}

const std::vector<double>* RobotCommands::due(std::int64_t step_ns) {
  last_step_ns_ = step_ns;
  return schedule_.due(step_ns - latency_ns_);
}

void RobotCommands::disturb(std::int64_t latency_ns, double lost_share) {
  latency_ns_ = latency_ns;
  lost_share_ = lost_share;
}

bool RobotCommands::expects(std::int64_t time_ns) const {
  return period_ns_ > 0 && schedule_.newestStamp_ns() + period_ns_ <= time_ns;
}

bool RobotCommands::take(const sensor_msgs::JointState& command) {
  ++counts_.received;
  const bool matches = matcher_.match(command.name, command.position);
  if (!matches) problem_ = matcher_.problem();
  if (!matches || !withinLimits(matcher_.values())) {
    ++counts_.refused;
    return false;
  }
  if (random_.chance(lost_share_)) {
    ++counts_.lost;
    return true;
  }
  const std::int64_t before_ns = schedule_.newestStamp_ns();
  switch (schedule_.add(toNs(command.header.stamp), last_step_ns_, matcher_.values())) {
    case CommandSchedule::Arrival::kScheduled:
      break;
    case CommandSchedule::Arrival::kLate:
      ++counts_.late;
      break;
    case CommandSchedule::Arrival::kForeign:
      ++counts_.foreign;
      break;
    case CommandSchedule::Arrival::kOld:
    case CommandSchedule::Arrival::kFull:
      ++counts_.dropped;
      break;
  }
  const std::int64_t period_ns = schedule_.newestStamp_ns() - before_ns;
  period_ns_ = before_ns > 0 && period_ns <= kLongestPeriod_ns ? period_ns : 0;
  return true;
}

bool RobotCommands::withinLimits(const std::vector<double>& targets_rad) {
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const Joint& joint = joints_[j];
    if (targets_rad[j] >= joint.lower_rad - kLimitSlack_rad &&
        targets_rad[j] <= joint.upper_rad + kLimitSlack_rad) {
      continue;
    }
    problem_ = "The target of joint '" + joint.name + "' is " + std::to_string(targets_rad[j]) +
               " rad; expected " + std::to_string(joint.lower_rad) + " .. " +
               std::to_string(joint.upper_rad) + " rad.";
    return false;
  }
  return true;
}

}  // namespace hexapod
