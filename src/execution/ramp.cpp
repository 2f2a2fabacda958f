#include "execution/ramp.h"

#include <algorithm>
#include <cmath>

namespace hexapod {
namespace {

// The cubic 3 s^2 - 2 s^3 moves at most 1.5 times as fast as the straight line.
constexpr double kPeakVelocity = 1.5;

}  // namespace

Ramp::Ramp(const RobotDescription& robot) : from_(robot.neutralPose()), to_(from_) {
  for (const Joint* joint : robot.joints()) max_velocity_.push_back(joint->max_velocity_rad_per_s);
}

void Ramp::plan(const std::vector<double>& from, const std::vector<double>& to, double hold_s,
                double duration_s, double period_s) {
  std::copy(from.begin(), from.end(), from_.begin());
  std::copy(to.begin(), to.end(), to_.begin());
  for (std::size_t j = 0; j < from_.size(); ++j) {
    duration_s =
        std::max(duration_s, kPeakVelocity * std::abs(to_[j] - from_[j]) / max_velocity_[j]);
  }
  hold_ = static_cast<std::int64_t>(std::ceil(hold_s / period_s));
  moving_ = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(duration_s / period_s)));
}

void Ramp::pose(std::int64_t index, std::vector<double>& pose_rad) const {
  const double s =
      std::clamp(static_cast<double>(index - hold_) / static_cast<double>(moving_), 0.0, 1.0);
  if (s == 1.0) {
    std::copy(to_.begin(), to_.end(), pose_rad.begin());
    return;
  }
  const double fraction = s * s * (3.0 - 2.0 * s);
  for (std::size_t j = 0; j < from_.size(); ++j) {
    pose_rad[j] = from_[j] + fraction * (to_[j] - from_[j]);
  }
}

}  // namespace hexapod
