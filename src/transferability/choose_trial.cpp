#include "transferability/choose_trial.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hexapod {

std::size_t farthestFromTried(const std::vector<Entry>& entries,
                              const std::vector<RobotTrial>& trials, const FeatureScales& scales) {
  std::vector<Pose2> tried{Pose2()};
  for (const RobotTrial& trial : trials) {
    tried.push_back(trial.simulated);
    for (const Symmetry& symmetry : scales.symmetries) {
      tried.push_back(symmetry.image(trial.simulated));
    }
  }
  std::size_t farthest = 0;
  double far_m = -1.0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Pose2& end = entries[i].end_pose;
    double least_m = std::numeric_limits<double>::infinity();
    for (const Pose2& other : tried) {
      least_m = std::min(
          least_m, std::hypot(distance(end, other), scales.length_m * headingDistance(end, other)));
    }
    if (least_m <= far_m) continue;
    far_m = least_m;
    farthest = i;
  }
  return farthest;
}

}  // namespace hexapod
