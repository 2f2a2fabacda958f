#include "self_model/evidence.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace hexapod {
namespace {

// A joint that moved otherwise than imagined, or was not read, counts at most so much.
constexpr double kMostOfAJoint = 4.0;
// A joint of a leg that is gone was read all the same: of one that broke off further down.
constexpr double kReadThoughMissing = 2.0;
// Imagined to fall or to touch its own legs, and yet there it stands.
constexpr double kFailure = -4.0;

}  // namespace

Eigen::Vector3d difference(const Pose2& measured, const Pose2& imagined) {
  return {measured.x_m - imagined.x_m, measured.y_m - imagined.y_m,
          wrapAngle(measured.yaw_rad - imagined.yaw_rad)};
}

Evidence::Evidence(const RobotDescription& robot, const BeliefOptions& options)
    : joint_variance_rad2_(std::pow(options.joint_noise_rad, 2)) {
  for (std::size_t leg = 0; leg < robot.legs.size(); ++leg) {
    leg_of_joint_.insert(leg_of_joint_.end(), robot.legs[leg].segments.size(), leg);
  }
  // The pose is measured before and after.
  const double m = options.measurement_noise_m, rad = options.measurement_noise_rad;
  const double position = std::pow(options.model_noise_m, 2) + 2.0 * m * m;
  const double heading = std::pow(options.model_noise_rad, 2) + 2.0 * rad * rad;
  noise_ = Eigen::Vector3d(position, position, heading).asDiagonal();
}

void Evidence::judge(const SeenBehavior& seen, BelievedBody& body) const {
  body.misfit = kAccident;
  body.log_likelihood = -kMostEvidence;
  if (body.imagined.verdict == Verdict::kDiverged) return;
  const Eigen::Vector3d residual = difference(seen.startFromEnd(), body.imagined.start_from_end);
  const Eigen::Matrix3d covariance = body.scatter + noise_;
  body.misfit = residual.dot(covariance.inverse() * residual);
  body.log_likelihood =
      -0.5 * (body.misfit + std::log(covariance.determinant() / noise_.determinant()));
  if (body.imagined.verdict != Verdict::kWalked) body.log_likelihood += kFailure;
  body.log_likelihood -= againstByJoints(seen, body);
}

double Evidence::againstByJoints(const SeenBehavior& seen, const BelievedBody& body) const {
  const std::vector<JointRange>& imagined = body.imagined.joints;
  if (seen.joints.size() != imagined.size()) return 0.0;
  double against = 0.0;
  for (std::size_t j = 0; j < imagined.size(); ++j) {
    const LegCondition condition = body.legs[leg_of_joint_[j]].condition;
    against += againstByJoint(seen.joints[j], imagined[j], condition == LegCondition::kMissing);
  }
  return against;
}

double Evidence::againstByJoint(const JointRange& seen, const JointRange& imagined,
                                bool is_missing) const {
  const bool is_read = std::isfinite(seen.min_rad) && std::isfinite(seen.max_rad);
  if (is_missing) return is_read ? kReadThoughMissing : 0.0;
  if (!is_read) return kMostOfAJoint;
  const double low_rad = seen.min_rad - imagined.min_rad;
  const double high_rad = seen.max_rad - imagined.max_rad;
  return std::min(0.5 * (low_rad * low_rad + high_rad * high_rad) / joint_variance_rad2_,
                  kMostOfAJoint);
}

}  // namespace hexapod
