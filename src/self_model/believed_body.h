#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/pose2.h"
#include "self_model/body.h"
#include "self_model/imagination.h"

namespace hexapod {

/// What was walked, as a belief sees it.
struct SeenBehavior {
  Genome genome;
  Pose2 world_from_before, world_from_after;
  std::vector<JointRange> joints;  ///< as in WalkedStep

  /// Where the behaviour led, in the frame where it began.
  Pose2 startFromEnd() const { return inverse(world_from_before) * world_from_after; }

  Imagination::Joints jointsMatter() const {
    return joints.empty() ? Imagination::Joints::kIgnored : Imagination::Joints::kWatched;
  }
};

/// One body that the robot may have, as far as it is known.
struct BelievedBody {
  std::vector<LegState> legs;  ///< one per leg
  BodyVector mean = BodyVector::Zero();
  BodyMatrix covariance = BodyMatrix::Zero();
  double log_prior = 0.0;
  double log_weight = 0.0;  ///< 0 for the most likely body
  WorldState stand;         ///< in which it comes to rest in the neutral pose
  WorldState state;  ///< in which it is thought to stand: footprint at the origin, its heading
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();  ///< of its predictions, by the covariance

  /// Of the last behaviour:
  /// @{
  Imagined imagined;            ///< what this body makes of it
  double log_likelihood = 0.0;  ///< of what was measured
  double misfit = 0.0;          ///< squared Mahalanobis distance of that, 3 expected
  /// @}
};

}  // namespace hexapod
