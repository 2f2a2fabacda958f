#include "self_model/belief_prior.h"

#include <algorithm>
#include <cmath>

namespace hexapod {
namespace {

// In standard deviations that are possible.
constexpr double kFarOff[] = {1.0, 2.0};
// So many of the single legs that explain most are paired with any other.
constexpr std::size_t kLegsToPair = 3;

const LegCondition kDamages[] = {LegCondition::kLifted, LegCondition::kLocked,
                                 LegCondition::kMissing, LegCondition::kLimp};

// Most explaining first.
std::vector<const BelievedBody*> singlesOf(const std::vector<BelievedBody>& bodies) {
  std::vector<const BelievedBody*> singles;
  for (const BelievedBody& body : bodies) {
    if (legsOutOfOrder(body.legs) == 1) singles.push_back(&body);
  }
  std::stable_sort(
      singles.begin(), singles.end(),
      [](const BelievedBody* a, const BelievedBody* b) { return a->misfit < b->misfit; });
  return singles;
}

bool has(const std::vector<BelievedBody>& bodies, const std::vector<LegState>& legs) {
  return std::any_of(bodies.begin(), bodies.end(),
                     [&](const BelievedBody& body) { return body.legs == legs; });
}

BelievedBody pairOf(const BelievedBody& single, std::size_t other, LegCondition condition) {
  BelievedBody pair = single;
  pair.legs[other] = LegState{condition, {}};
  pair.mean.setZero();
  pair.covariance = priorCovariance(kLikely);
  pair.scatter = priorScatter(kLikely);
  pair.log_prior = pair.log_weight = kTwoLegs;
  return pair;
}

}  // namespace

BodyMatrix priorCovariance(double share) {
  BodyVector variances;
  for (int i = 0; i < kBodyParameters; ++i) {
    variances[i] = std::pow(share * bodyParameters()[i].prior_deviation, 2);
  }
  return variances.asDiagonal();
}

Eigen::Matrix3d priorScatter(double share) {
  return (Eigen::Vector3d(0.02, 0.02, 0.06) * share).array().square().matrix().asDiagonal();
}

std::vector<std::vector<LegState>> singleDamages(std::size_t legs) {
  std::vector<std::vector<LegState>> damaged;
  for (std::size_t leg = 0; leg < legs; ++leg) {
    for (const LegCondition condition : kDamages) {
      damaged.emplace_back(legs);
      damaged.back()[leg].condition = condition;
    }
  }
  return damaged;
}

std::vector<BodyVector> farOff() {
  std::vector<BodyVector> means;
  for (int i = 0; i < kBodyParameters; ++i) {
    for (const double far : kFarOff) {
      for (const double side : {1.0, -1.0}) {
        means.push_back(BodyVector::Zero());
        means.back()[i] = side * far * bodyParameters()[i].prior_deviation;
      }
    }
  }
  return means;
}

std::vector<BelievedBody> likelyPairs(const std::vector<BelievedBody>& bodies) {
  const std::vector<const BelievedBody*> singles = singlesOf(bodies);
  std::vector<BelievedBody> pairs;
  for (std::size_t k = 0; k < singles.size(); ++k) {
    const std::vector<LegState>& legs = singles[k]->legs;
    for (std::size_t other = 0; other < legs.size(); ++other) {
      if (legs[other].condition != LegCondition::kIntact) continue;
      for (const LegCondition condition : kDamages) {
        const bool alike =
            std::find(legs.begin(), legs.end(), LegState{condition, {}}) != legs.end();
        if (k >= kLegsToPair && !alike) continue;
        BelievedBody pair = pairOf(*singles[k], other, condition);
        if (!has(pairs, pair.legs) && !has(bodies, pair.legs)) pairs.push_back(std::move(pair));
      }
    }
  }
  return pairs;
}

std::size_t legsOutOfOrder(const std::vector<LegState>& legs) {
  return static_cast<std::size_t>(std::count_if(legs.begin(), legs.end(), [](const LegState& leg) {
    return leg.condition != LegCondition::kIntact;
  }));
}

}  // namespace hexapod
