#include "self_model/describe_belief.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "common/text.h"

namespace hexapod {

std::vector<LikelyLegs> likelyLegs(const RobotDescription& robot, const BodyBelief& belief,
                                   double least) {
  std::vector<LikelyLegs> likely;
  for (std::size_t i = 0; i < belief.bodies().size(); ++i) {
    const std::string legs = describeLegs(robot, belief.bodies()[i].legs);
    const auto known = std::find_if(likely.begin(), likely.end(),
                                    [&](const LikelyLegs& one) { return one.legs == legs; });
    if (known == likely.end()) {
      likely.push_back({legs, belief.probability(i)});
    } else {
      known->probability += belief.probability(i);
    }
  }
  std::stable_sort(likely.begin(), likely.end(), [](const LikelyLegs& a, const LikelyLegs& b) {
    return a.probability > b.probability;
  });
  while (likely.size() > 1 && likely.back().probability < least) likely.pop_back();
  return likely;
}

std::string describe(const RobotDescription& robot, const BodyBelief& belief) {
  std::string text;
  for (const LikelyLegs& one : likelyLegs(robot, belief, 0.05)) {
    text += (text.empty() ? "" : ", or ") + one.legs + " (" +
            fixedText(100.0 * one.probability, 0) + " %)";
  }
  const BelievedBody& best = belief.bodies().front();
  for (int i = 0; i < kBodyParameters; ++i) {
    const double deviation = std::sqrt(best.covariance(i, i));
    if (std::abs(best.mean[i]) <= deviation) continue;
    const bool is_scale = std::string(bodyParameters()[i].unit).empty();
    const double value = is_scale ? std::exp(best.mean[i]) : best.mean[i];
    text += std::string("; ") + bodyParameters()[i].name + " " + numberText(value, 2) + " +- " +
            numberText(deviation, 2);
  }
  return text;
}

}  // namespace hexapod
