#include "transferability/behavior_features.h"

#include <algorithm>
#include <cmath>

#include "geometry/arc.h"

namespace hexapod {

BehaviorFeatures featuresOf(const Genome& genome, const Outcome& simulated,
                            const FeatureScales& scales) {
  BehaviorFeatures features;
  const Pose2& end = simulated.end_pose;
  features.end = {end.x_m / scales.length_m, end.y_m / scales.length_m, end.yaw_rad};
  features.gait.resize(static_cast<Eigen::Index>(genome.size()));
  for (std::size_t gene = 0; gene + 1 < genome.size(); gene += 2) {
    const double amplitude = geneValue(genome[gene], scales.gene_levels);
    const double angle = 2.0 * M_PI * geneValue(genome[gene + 1], scales.gene_levels);
    const auto i = static_cast<Eigen::Index>(gene);
    features.gait[i] = amplitude * std::cos(angle);
    features.gait[i + 1] = amplitude * std::sin(angle);
  }
  features.doubt = std::max(0.0, simulated.cost - orientationError(end));
  return features;
}

std::vector<BehaviorImage> imagesOf(const Genome& genome, const Outcome& simulated,
                                    const FeatureScales& scales) {
  std::vector<BehaviorImage> images{{featuresOf(genome, simulated, scales), {1.0, 1.0, 1.0}}};
  for (const Symmetry& symmetry : scales.symmetries) {
    const Pose2 signs = symmetry.image(Pose2{1.0, 1.0, 1.0});
    images.push_back({featuresOf(symmetry.image(genome), symmetry.image(simulated), scales),
                      {signs.x_m, signs.y_m, signs.yaw_rad}});
  }
  return images;
}

}  // namespace hexapod
