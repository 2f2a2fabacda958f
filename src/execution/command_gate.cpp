#include "execution/command_gate.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/text.h"

namespace hexapod {
namespace {

// Room for the rounding of a sequence that keeps the limits exactly.
constexpr double kRelativeSlack = 1e-9;

// The longest step [rad] from which a joint whose steps become shorter by `change_rad` each comes
// to rest within `room_rad`. Steps n c, (n-1) c, .., c cover c n (n+1) / 2.
double longestStep(double room_rad, double change_rad) {
  if (room_rad <= 0.0) return 0.0;
  const double n = std::floor((std::sqrt(1.0 + 8.0 * room_rad / change_rad) - 1.0) / 2.0);
  return (room_rad + change_rad * n * (n + 1.0) / 2.0) / (n + 1.0);
}

}  // namespace

CommandGate::CommandGate(const RobotDescription& robot, double period_s, const GateOptions& options)
    : step_change_rad_(options.max_acceleration_rad_per_s2 * period_s * period_s *
                       (1.0 + kRelativeSlack)),
      last_(robot.neutralPose()),
      requested_(last_),
      step_(last_.size(), 0.0) {
  for (const Joint* joint : robot.joints()) {
    const double neutral_rad = last_[limits_.size()];
    const double step_rad = joint->max_velocity_rad_per_s * period_s * (1.0 + kRelativeSlack);
    const double lower_rad = joint->lower_rad + options.soft_limit_margin_rad;
    const double upper_rad = joint->upper_rad - options.soft_limit_margin_rad;
    if (neutral_rad < lower_rad || neutral_rad > upper_rad) {
      throw std::invalid_argument("Option soft_limit_margin_rad is " +
                                  numberText(options.soft_limit_margin_rad) +
                                  " rad and forbids the neutral angle of joint '" + joint->name +
                                  "'; give a smaller margin.");
    }
    limits_.push_back({joint->lower_rad, joint->upper_rad, lower_rad, upper_rad, step_rad});
  }
}

void CommandGate::reset(const std::vector<double>& pose_rad) {
  for (std::size_t j = 0; j < limits_.size(); ++j) {
    last_[j] = std::clamp(pose_rad[j], limits_[j].lower_rad, limits_[j].upper_rad);
  }
  requested_ = last_;
  rest();
}

void CommandGate::rest() { std::fill(step_.begin(), step_.end(), 0.0); }

CommandGate::Passage CommandGate::pass(const std::vector<double>& requested_rad) {
  if (!acceptable(requested_rad)) return Passage::kRefused;
  bool clamped = false;
  for (std::size_t j = 0; j < limits_.size(); ++j) {
    const double passed_rad = nextAngle(j, requested_rad[j]);
    clamped = clamped || passed_rad != requested_rad[j];
    step_[j] = passed_rad - last_[j];
    last_[j] = passed_rad;
    requested_[j] = requested_rad[j];
  }
  if (clamped) ++clamped_count_;
  return clamped ? Passage::kClamped : Passage::kUnchanged;
}

double CommandGate::nextAngle(std::size_t j, double requested_rad) const {
  const Limits& limits = limits_[j];
  const double last_rad = last_[j];
  // A joint found within the margin may stay there.
  const double lower_rad = std::min(limits.soft_lower_rad, last_rad);
  const double upper_rad = std::max(limits.soft_upper_rad, last_rad);
  double lowest_rad = -limits.step_rad;
  double highest_rad = limits.step_rad;
  if (step_change_rad_ > 0.0) {
    highest_rad = std::min({highest_rad, step_[j] + step_change_rad_,
                            longestStep(upper_rad - last_rad, step_change_rad_)});
    lowest_rad = std::max({lowest_rad, step_[j] - step_change_rad_,
                           -longestStep(last_rad - lower_rad, step_change_rad_)});
  }
  double step_rad = requested_rad - last_rad;
  if (step_rad >= lowest_rad && step_rad <= highest_rad && staysWith(j, requested_rad)) {
    return std::clamp(requested_rad, lower_rad, upper_rad);
  }
  if (step_change_rad_ > 0.0) {
    step_rad = std::copysign(longestStep(std::abs(step_rad), step_change_rad_), step_rad);
  }
  // Rounding may leave nothing between the two; then braking comes first.
  step_rad = std::min(std::max(step_rad, lowest_rad), highest_rad);
  return std::clamp(last_rad + step_rad, lower_rad, upper_rad);
}

// Arrived at the request, could the joint go on as the requests do?
bool CommandGate::staysWith(std::size_t j, double requested_rad) const {
  const double request_step_rad = requested_rad - requested_[j];
  return step_change_rad_ <= 0.0 ||
         std::abs(requested_rad - last_[j] - request_step_rad) <= step_change_rad_;
}

bool CommandGate::acceptable(const std::vector<double>& requested_rad) const {
  return requested_rad.size() == limits_.size() &&
         std::all_of(requested_rad.begin(), requested_rad.end(),
                     [](double angle_rad) { return std::isfinite(angle_rad); });
}

}  // namespace hexapod
