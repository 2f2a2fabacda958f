#pragma once

#include <vector>

#include "self_model/believed_body.h"

namespace hexapod {

/// What is thought of bodies before anything was walked.

/// Logarithms of how likely a leg, or two, are thought to be out of order.
constexpr double kOneLeg = -5.0;
constexpr double kTwoLegs = -9.0;
/// That an intact robot is otherwise by far in one parameter.
constexpr double kOtherwise = -4.7;
/// Most robots are nearly as they were learned: so much of what is possible is thought likely,
/// until that does not explain what is seen.
constexpr double kLikely = 0.3;

/// `share` of the deviations that are possible.
BodyMatrix priorCovariance(double share);

/// About what that does to an end pose.
Eigen::Matrix3d priorScatter(double share);

/// Every leg in every condition but intact, one at a time.
std::vector<std::vector<LegState>> singleDamages(std::size_t legs);

/// One parameter each far from what was learned: a linear update alone would not get there when the
/// way is not straight.
std::vector<BodyVector> farOff();

/// Pairs of legs worth trying: the single legs of `bodies` that explain most, each with any other
/// leg, and legs that went the same way; none that `bodies` has. They stand as the single leg's
/// body does.
std::vector<BelievedBody> likelyPairs(const std::vector<BelievedBody>& bodies);

/// How many legs are not intact.
std::size_t legsOutOfOrder(const std::vector<LegState>& legs);

}  // namespace hexapod
