#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "gait/genome.h"
#include "gait/outcome.h"
#include "gait/symmetry.h"

namespace hexapod {

/// How behaviours are looked at when they are compared.
struct FeatureScales {
  double length_m = 0.3;  ///< what counts as much as a radian
  std::size_t gene_levels = kGeneLevels;
  std::vector<Symmetry> symmetries;  ///< of the robot, as its files describe it
};

/// What a disparity may depend on.
struct BehaviorFeatures {
  Eigen::Vector3d end;   ///< in simulation: position over the length of the scales, heading [rad]
  Eigen::VectorXd gait;  ///< of each signal its amplitude times cosine and sine of its phase
  double doubt = 0.0;    ///< of simulation itself: the share of the cost beyond the heading's error
};

BehaviorFeatures featuresOf(const Genome& genome, const Outcome& simulated,
                            const FeatureScales& scales);

/// Behaviour and images: of each the features, and by what signs x, y and heading of a disparity
/// change with it. The behaviour itself comes first.
struct BehaviorImage {
  BehaviorFeatures features;
  Eigen::Vector3d signs = Eigen::Vector3d::Ones();
};
std::vector<BehaviorImage> imagesOf(const Genome& genome, const Outcome& simulated,
                                    const FeatureScales& scales);

}  // namespace hexapod
