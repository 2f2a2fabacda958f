#include "planning/deviation.h"

#include <algorithm>
#include <cmath>

namespace hexapod {
namespace {

constexpr double kForgetting = 0.9;

// Variance of one measurement over variance expected of the deviation. Displacement: 1 cm against
// 5 % of scale; heading: 1.5 degrees against 5 degrees of shift and 0.2 of scale.
constexpr double kScalePrior_m2 = 0.04;
constexpr double kTurnPrior = 0.09;
constexpr double kTurnScalePrior_rad2 = 0.017;

constexpr double kAccident_m = 0.1;
constexpr double kAccident_rad = M_PI / 4.0;

constexpr double kNoise = 0.05;
constexpr double kNoise_rad = 0.035;
constexpr double kLargest_rad = M_PI / 6.0;
constexpr double kStep = 0.04;
constexpr double kStep_rad = M_PI / 120.0;

bool isAccident(const Pose2& expected, const Pose2& measured) {
  if (!isFinite(expected) || !isFinite(measured)) return true;
  const double expected_m = std::hypot(expected.x_m, expected.y_m);
  const double measured_m = std::hypot(measured.x_m, measured.y_m);
  return headingDistance(expected, measured) > kAccident_rad ||
         (std::abs(measured_m - expected_m) > kAccident_m &&
          (measured_m < 0.4 * expected_m || measured_m > 2.5 * expected_m));
}

double rounded(double value, double step) { return step * std::round(value / step); }

}  // namespace

Pose2 Deviation::apply(const Pose2& start_from_end) const {
  const Pose2 turned = Pose2{0.0, 0.0, direction_rad} * start_from_end;
  return {scale * turned.x_m, scale * turned.y_m,
          wrapAngle(turn_scale * start_from_end.yaw_rad + turn_rad)};
}

bool Deviation::operator==(const Deviation& other) const {
  return scale == other.scale && direction_rad == other.direction_rad &&
         turn_scale == other.turn_scale && turn_rad == other.turn_rad;
}

void DeviationEstimator::observe(const Pose2& expected, const Pose2& measured) {
  if (isAccident(expected, measured)) return;
  const auto add = [](double& sum, double value) { sum = kForgetting * sum + value; };
  add(expected_squared_, expected.x_m * expected.x_m + expected.y_m * expected.y_m);
  add(along_, expected.x_m * measured.x_m + expected.y_m * measured.y_m);
  add(across_, expected.x_m * measured.y_m - expected.y_m * measured.x_m);
  const double error_rad = wrapAngle(measured.yaw_rad - expected.yaw_rad);
  add(count_, 1.0);
  add(turn_sum_, expected.yaw_rad);
  add(turn_squared_, expected.yaw_rad * expected.yaw_rad);
  add(error_sum_, error_rad);
  add(error_turn_, error_rad * expected.yaw_rad);
}

Deviation DeviationEstimator::deviation() const {
  // The displacement as complex numbers: measured = factor * expected.
  const double weight = kScalePrior_m2 + expected_squared_;
  const double real = (kScalePrior_m2 + along_) / weight;
  const double imaginary = across_ / weight;
  // heading error = turn + (turn scale - 1) * expected heading change.
  const double a = kTurnPrior + count_;
  const double d = kTurnScalePrior_rad2 + turn_squared_;
  const double determinant = a * d - turn_sum_ * turn_sum_;
  const double turn_rad = (d * error_sum_ - turn_sum_ * error_turn_) / determinant;
  const double extra_turn = (a * error_turn_ - turn_sum_ * error_sum_) / determinant;

  const double extra = std::hypot(real, imaginary) - 1.0;
  const double direction_rad = std::atan2(imaginary, real);
  if (std::abs(extra) < kNoise && std::abs(direction_rad) < kNoise_rad &&
      std::abs(extra_turn) < 2.0 * kNoise && std::abs(turn_rad) < kNoise_rad) {
    return {};
  }
  Deviation result;
  result.scale = 1.0 + std::clamp(rounded(extra, kStep), -0.5, 1.0);
  result.direction_rad = std::clamp(rounded(direction_rad, kStep_rad), -kLargest_rad, kLargest_rad);
  result.turn_scale = 1.0 + std::clamp(rounded(extra_turn, kStep), -0.5, 1.0);
  result.turn_rad = std::clamp(rounded(turn_rad, kStep_rad), -kLargest_rad, kLargest_rad);
  return result;
}

void DeviationForesight::observe(const WalkedStep& step) {
  const std::lock_guard<std::mutex> lock(mutex_);
  estimator_.observe(step.entry.expectedPose(),
                     inverse(step.world_from_before) * step.world_from_after);
}

std::shared_ptr<const Repertoire> DeviationForesight::expected(
    const std::shared_ptr<const Repertoire>& repertoire) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Deviation deviation = estimator_.deviation();
  if (deviation == Deviation{}) return repertoire;
  if (undeviated_ == repertoire && deviation == deviation_) return deviating_;
  auto made = std::make_shared<Repertoire>(*repertoire);
  for (Entry& entry : made->entries) {
    entry.end_pose = deviation.apply(entry.end_pose);
    if (entry.execution) entry.execution->mean = deviation.apply(entry.execution->mean);
  }
  undeviated_ = repertoire;
  deviation_ = deviation;
  deviating_ = made;
  return deviating_;
}

}  // namespace hexapod
