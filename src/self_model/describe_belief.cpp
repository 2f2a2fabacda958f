#include "self_model/describe_belief.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

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
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(2);
  for (const LikelyLegs& one : likelyLegs(robot, belief, 0.05)) {
    text << (text.tellp() > 0 ? ", or " : "") << one.legs << " ("
         << std::lround(100.0 * one.probability) << " %)";
  }
  const BelievedBody& best = belief.bodies().front();
  for (int i = 0; i < kBodyParameters; ++i) {
    const double deviation = std::sqrt(best.covariance(i, i));
    if (std::abs(best.mean[i]) <= deviation) continue;
    const bool is_scale = std::string(bodyParameters()[i].unit).empty();
    text << "; " << bodyParameters()[i].name << " "
         << (is_scale ? std::exp(best.mean[i]) : best.mean[i]) << " +- " << deviation;
  }
  return text.str();
}

}  // namespace hexapod
