#include "execution/command_gate.h"

#include <algorithm>
#include <cmath>

namespace hexapod {
namespace {

// Room for the rounding of a sequence that keeps the limit exactly.
constexpr double kRelativeSlack = 1e-9;

}  // namespace

CommandGate::CommandGate(const RobotDescription& robot, double period_s, bool limit_velocity)
    : limit_velocity_(limit_velocity), last_(robot.neutralPose()) {
  for (const Joint* joint : robot.joints()) {
    const double step_rad = joint->max_velocity_rad_per_s * period_s * (1.0 + kRelativeSlack);
    limits_.push_back({joint->lower_rad, joint->upper_rad, step_rad});
  }
}

void CommandGate::reset(const std::vector<double>& pose_rad) {
  for (std::size_t j = 0; j < limits_.size(); ++j) {
    last_[j] = std::clamp(pose_rad[j], limits_[j].lower_rad, limits_[j].upper_rad);
  }
}

CommandGate::Passage CommandGate::pass(const std::vector<double>& requested_rad) {
  if (!acceptable(requested_rad)) return Passage::kRefused;
  bool clamped = false;
  for (std::size_t j = 0; j < limits_.size(); ++j) {
    const Limits& limits = limits_[j];
    double passed = requested_rad[j];
    if (limit_velocity_) {
      passed = std::clamp(passed, last_[j] - limits.step_rad, last_[j] + limits.step_rad);
    }
    passed = std::clamp(passed, limits.lower_rad, limits.upper_rad);
    clamped = clamped || passed != requested_rad[j];
    last_[j] = passed;
  }
  if (clamped) ++clamped_count_;
  return clamped ? Passage::kClamped : Passage::kUnchanged;
}

bool CommandGate::acceptable(const std::vector<double>& requested_rad) const {
  return requested_rad.size() == limits_.size() &&
         std::all_of(requested_rad.begin(), requested_rad.end(),
                     [](double angle_rad) { return std::isfinite(angle_rad); });
}

}  // namespace hexapod
