#pragma once

#include <string>
#include <vector>

#include "self_model/body_belief.h"

namespace hexapod {

/// Bodies that differ in their legs, with the probabilities of all that agree in them together.
struct LikelyLegs {
  std::string legs;  ///< as describeLegs()
  double probability = 0.0;
};

/// The most likely ones first, those of at least `least` probability, at least one.
std::vector<LikelyLegs> likelyLegs(const RobotDescription& robot, const BodyBelief& belief,
                                   double least = 0.01);

/// "left_middle: lifted (97 %), friction x 0.93, ...": the legs, and of the most likely body those
/// parameters that differ by more than their standard deviation.
std::string describe(const RobotDescription& robot, const BodyBelief& belief);

}  // namespace hexapod
