#include "transferability/disparity_model.h"

#include <cmath>

namespace hexapod {
namespace {

Outcome simulatedOf(const Pose2& end, double cost) { return {Verdict::kWalked, end, cost}; }

/// Measured minus simulated, in the units of the features.
Eigen::Vector3d disparityOf(const RobotTrial& trial, double length_m) {
  const Pose2 measured = trial.measured.value_or(Pose2());
  return {(measured.x_m - trial.simulated.x_m) / length_m,
          (measured.y_m - trial.simulated.y_m) / length_m,
          wrapAngle(measured.yaw_rad - trial.simulated.yaw_rad)};
}

}  // namespace

DisparityModel::DisparityModel(const FeatureScales& scales, double weight_rad_per_m,
                               const std::vector<RobotTrial>& trials)
    : scales_(scales), weight_rad_per_m_(weight_rad_per_m) {
  std::vector<std::vector<BehaviorImage>> tried;
  Eigen::Matrix<double, Eigen::Dynamic, 3> measured(static_cast<Eigen::Index>(trials.size()), 3);
  for (const RobotTrial& trial : trials) {
    measured.row(static_cast<Eigen::Index>(tried.size())) = disparityOf(trial, scales_.length_m);
    tried.push_back(imagesOf(trial.genome, simulatedOf(trial.simulated, trial.cost), scales_));
    if (!trial.measured) fell_.insert(trial.genome);
  }
  for (int c = 0; c < 3; ++c) coordinates_.emplace_back(tried, measured.col(c), c);
}

Disparity DisparityModel::expected(const Genome& genome, const Outcome& simulated) const {
  const std::vector<BehaviorImage> images = imagesOf(genome, simulated, scales_);
  const DisparityProcess::Value x = coordinates_[0].at(images), y = coordinates_[1].at(images),
                                heading = coordinates_[2].at(images);
  return {{scales_.length_m * x.mean, scales_.length_m * y.mean, heading.mean},
          scales_.length_m * std::sqrt(x.variance + y.variance),
          std::sqrt(heading.variance)};
}

double DisparityModel::disparity(const Genome& genome, const Outcome& simulated) const {
  const Disparity expected = this->expected(genome, simulated);
  return weight_rad_per_m_ *
         std::hypot(expected.shift.x_m, expected.shift.y_m, expected.deviation_m);
}

Execution DisparityModel::onRobot(const Entry& entry) const {
  Execution execution = *entry.execution;
  const Disparity expected = this->expected(entry.genome, simulatedOf(entry.end_pose, entry.cost));
  execution.mean.x_m += expected.shift.x_m;
  execution.mean.y_m += expected.shift.y_m;
  execution.mean.yaw_rad = wrapAngle(execution.mean.yaw_rad + expected.shift.yaw_rad);
  execution.spread_m = std::hypot(execution.spread_m, expected.deviation_m);
  execution.spread_rad = std::hypot(execution.spread_rad, expected.deviation_rad);
  if (fell_.count(entry.genome) > 0) {
    ++execution.trials;
    ++execution.falls;
  }
  return execution;
}

}  // namespace hexapod
