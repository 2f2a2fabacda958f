#pragma once

#include <Eigen/Core>

#include "robot/robot_description.h"
#include "self_model/believed_body.h"

namespace hexapod {

/// How a belief judges what it sees.
struct BeliefOptions {
  double model_noise_m = 0.005;        ///< what simulation misses of an end pose, per axis
  double model_noise_rad = 0.015;      ///< and of its heading
  double measurement_noise_m = 0.0;    ///< of a measured position, per axis
  double measurement_noise_rad = 0.0;  ///< of a measured heading
  double joint_noise_rad = 0.1;        ///< of how far a joint was seen to move
};

/// A behaviour's evidence counts no more than this against any body.
constexpr double kMostEvidence = 30.0;
/// Misfit of a body that does not walk so at all.
constexpr double kAccident = 100.0;

/// How well bodies explain a behaviour: by where it ended, and by how far the joints moved.
/// Likelihoods are cut, so that one accident decides little. Immutable.
class Evidence {
 public:
  Evidence(const RobotDescription& robot, const BeliefOptions& options);

  /// Sets misfit and likelihood of a body by what it imagined.
  void judge(const SeenBehavior& seen, BelievedBody& body) const;

  /// Covariance of an end pose about where the right body ends.
  const Eigen::Matrix3d& noise() const { return noise_; }

 private:
  double againstByJoints(const SeenBehavior& seen, const BelievedBody& body) const;
  double againstByJoint(const JointRange& seen, const JointRange& imagined, bool is_missing) const;

  std::vector<std::size_t> leg_of_joint_;
  double joint_variance_rad2_;
  Eigen::Matrix3d noise_;
};

/// x, y and heading by which a pose was missed.
Eigen::Vector3d difference(const Pose2& measured, const Pose2& imagined);

}  // namespace hexapod
