#include "self_model/body_belief.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace hexapod {
namespace {

// Logarithms of how likely a leg, or two, are thought to be out of order beforehand.
constexpr double kOneLeg = -5.0;
constexpr double kTwoLegs = -9.0;
// That an intact robot is otherwise by kFarOff times a parameter's deviation.
constexpr double kOtherwise = -4.0;
constexpr double kFarOff = 1.4;
// A behaviour's evidence fades by this per behaviour, and counts no more than kMostEvidence against
// any body; none is held less likely than kLeastWeight below the best.
constexpr double kFading = 0.9;
constexpr double kMostEvidence = 30.0;
constexpr double kLeastWeight = -20.0;
// A joint that moved otherwise than imagined counts at most so much.
constexpr double kMostOfAJoint = 4.0;
// A joint of a leg that is gone was read all the same: of one that broke off further down.
constexpr double kReadThoughMissing = 2.0;
// Imagined to fall or to touch its own legs, and yet there it stands.
constexpr double kFailure = -4.0;
// Bodies this far below the best are not refined, and not more than so many.
constexpr double kWorthRefining = 10.0;
constexpr std::size_t kMostRefined = 4;
// Squared Mahalanobis distances of three dimensions: fits well, and is not explained.
constexpr double kFits = 8.0;
constexpr double kUnexplained = 12.0;
constexpr double kAccident = 100.0;
// Bodies with two legs out of order that are kept.
constexpr std::size_t kMostPairs = 6;
constexpr std::size_t kLegsToPair = 3;
// What is known of the parameters fades by this share of the prior per behaviour.
constexpr double kDrift = 0.02;
// Most robots are nearly as they were learned: so much of what is possible is thought likely, until
// that does not explain what is seen.
constexpr double kLikely = 0.3;
// The best of many pairs are worth settling.
constexpr std::size_t kMostSettled = 10;

// `share` of the deviations that are possible.
BodyMatrix priorCovariance(double share) {
  BodyVector variances;
  for (int i = 0; i < kBodyParameters; ++i) {
    variances[i] = std::pow(share * bodyParameters()[i].prior_deviation, 2);
  }
  return variances.asDiagonal();
}

// About what that does to an end pose.
Eigen::Matrix3d priorScatter(double share) {
  return (Eigen::Vector3d(0.02, 0.02, 0.06) * share).array().square().matrix().asDiagonal();
}

BodyMatrix squareRoot(const BodyMatrix& covariance) {
  return Eigen::LLT<BodyMatrix>(covariance).matrixL();
}

Eigen::Vector3d difference(const Pose2& measured, const Pose2& imagined) {
  return {measured.x_m - imagined.x_m, measured.y_m - imagined.y_m,
          wrapAngle(measured.yaw_rad - imagined.yaw_rad)};
}

std::size_t legsOutOfOrder(const std::vector<LegState>& legs) {
  return static_cast<std::size_t>(std::count_if(legs.begin(), legs.end(), [](const LegState& leg) {
    return leg.condition != LegCondition::kIntact;
  }));
}

const LegCondition kDamages[] = {LegCondition::kLifted, LegCondition::kLocked,
                                 LegCondition::kMissing, LegCondition::kLimp};

}  // namespace

BodyBelief::BodyBelief(std::shared_ptr<const Imagination> imagination, const Physics& nominal,
                       const BeliefOptions& options)
    : imagination_(std::move(imagination)), nominal_(nominal), options_(options) {
  const std::size_t legs = imagination_->robot().legs.size();
  const std::vector<LegState> intact(legs);
  std::vector<std::vector<LegState>> damaged;
  for (std::size_t leg = 0; leg < legs; ++leg) {
    for (const LegCondition condition : kDamages) {
      damaged.push_back(intact);
      damaged.back()[leg].condition = condition;
    }
  }
  share_ = kLikely;
  add({intact}, 0.0);
  addOtherwise(intact);
  add(damaged, kOneLeg);
  checkThatSomeStand();
  order();
}

BodyBelief::BodyBelief(std::shared_ptr<const Imagination> imagination, const Physics& told)
    : imagination_(std::move(imagination)), nominal_(told), certain_(true) {
  nominal_.legs.clear();
  nominal_.slope_x_rad = nominal_.slope_y_rad = 0.0;
  std::vector<LegState> legs = told.legs;
  legs.resize(imagination_->robot().legs.size());
  add({legs}, 0.0);
  checkThatSomeStand();
  bodies_[0].mean = parametersOf(told, nominal_);
  bodies_[0].covariance.setZero();
}

// Bodies that do not stand are left out: this robot does.
void BodyBelief::add(const std::vector<std::vector<LegState>>& bodies, double log_prior,
                     const BodyVector& mean) {
  std::vector<Physics> physics;
  for (const std::vector<LegState>& legs : bodies) {
    physics.push_back(hexapod::physicsOf(nominal_, legs, mean));
  }
  const std::vector<std::optional<WorldState>> stands = imagination_->stands(physics);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!stands[i]) continue;
    BelievedBody body;
    body.legs = bodies[i];
    body.mean = mean;
    body.covariance = priorCovariance(share_);
    body.scatter = priorScatter(share_);
    body.log_prior = body.log_weight = log_prior;
    body.state = *stands[i];
    bodies_.push_back(std::move(body));
  }
}

// Intact robots, one thing about each far from what was learned: a linear update alone would not
// get there when the way is not straight.
void BodyBelief::addOtherwise(const std::vector<LegState>& intact) {
  for (int i = 0; i < 2 * kBodyParameters; ++i) {
    const double deviation = kFarOff * bodyParameters()[i / 2].prior_deviation;
    BodyVector mean = BodyVector::Zero();
    mean[i / 2] = i % 2 == 0 ? deviation : -deviation;
    add({intact}, kOtherwise, mean);
  }
}

void BodyBelief::checkThatSomeStand() const {
  if (!bodies_.empty()) return;
  throw std::runtime_error("Robot '" + imagination_->robot().name +
                           "' does not stand in simulation with any of the bodies thought of; "
                           "change its neutral pose, masses or torques.");
}

double BodyBelief::probability(std::size_t i) const {
  double sum = 0.0;
  for (const BelievedBody& body : bodies_) sum += std::exp(body.log_weight);
  return std::exp(bodies_[i].log_weight) / sum;
}

void BodyBelief::observe(const SeenBehavior& seen) {
  heading_rad_ = seen.world_from_before.yaw_rad;
  imagined_.clear();
  likelihoods_.clear();
  imagineAll(seen, 0);
  if (!certain_) {
    refine(seen);
    if (leastMisfit() > kUnexplained) widen(seen);
    if (leastMisfit() > kUnexplained) tryPairs(seen);
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    BelievedBody& body = bodies_[i];
    if (imagined_[i].verdict != Verdict::kDiverged) {
      body.state = imagination_->turned(imagined_[i].end, seen.world_from_after.yaw_rad);
    }
    body.log_weight = body.log_prior + kFading * (body.log_weight - body.log_prior) +
                      std::max(likelihoods_[i], -kMostEvidence);
  }
  order();
  if (!certain_) forget();
}

Eigen::Matrix3d BodyBelief::noise() const {
  // The pose is measured before and after.
  const double m = options_.measurement_noise_m, rad = options_.measurement_noise_rad;
  const double position = std::pow(options_.model_noise_m, 2) + 2.0 * m * m;
  const double heading = std::pow(options_.model_noise_rad, 2) + 2.0 * rad * rad;
  return Eigen::Vector3d(position, position, heading).asDiagonal();
}

double BodyBelief::logLikelihood(const SeenBehavior& seen, const Imagined& imagined,
                                 BelievedBody& body) const {
  double& misfit = body.misfit;
  misfit = kAccident;
  if (imagined.verdict == Verdict::kDiverged) return -kMostEvidence;
  const Pose2 measured = inverse(seen.world_from_before) * seen.world_from_after;
  const Eigen::Vector3d residual = difference(measured, imagined.start_from_end);
  const Eigen::Matrix3d covariance = body.scatter + noise();
  misfit = residual.dot(covariance.inverse() * residual);
  double likelihood = -0.5 * (misfit + std::log(covariance.determinant() / noise().determinant()));
  if (imagined.verdict != Verdict::kWalked) likelihood += kFailure;
  return likelihood - evidenceOfJoints(seen, imagined, body.legs);
}

// What speaks against a body because its joints moved otherwise; they are counted leg by leg.
double BodyBelief::evidenceOfJoints(const SeenBehavior& seen, const Imagined& imagined,
                                    const std::vector<LegState>& legs) const {
  if (seen.joints.size() != imagined.joints.size()) return 0.0;
  const RobotDescription& robot = imagination_->robot();
  const double variance = std::pow(options_.joint_noise_rad, 2);
  double evidence = 0.0;
  std::size_t j = 0;
  for (std::size_t leg = 0; leg < robot.legs.size(); ++leg) {
    const bool missing = legs[leg].condition == LegCondition::kMissing;
    for (std::size_t k = 0; k < robot.legs[leg].segments.size(); ++k, ++j) {
      const bool read = std::isfinite(seen.joints[j].min_rad);
      const double low = seen.joints[j].min_rad - imagined.joints[j].min_rad;
      const double high = seen.joints[j].max_rad - imagined.joints[j].max_rad;
      if (missing) {
        evidence += read ? kReadThoughMissing : 0.0;
      } else {
        evidence += read ? std::min(0.5 * (low * low + high * high) / variance, kMostOfAJoint)
                         : kMostOfAJoint;
      }
    }
  }
  return evidence;
}

void BodyBelief::imagineAll(const SeenBehavior& seen, std::size_t first) {
  std::vector<Imagination::Question> questions;
  for (std::size_t i = first; i < bodies_.size(); ++i) {
    questions.push_back({physicsOf(bodies_[i]), &bodies_[i].state});
  }
  for (Imagined& imagined : imagination_->play(seen.genome, questions)) {
    BelievedBody& body = bodies_[imagined_.size()];
    likelihoods_.push_back(logLikelihood(seen, imagined, body));
    imagined_.push_back(std::move(imagined));
  }
}

void BodyBelief::refine(const SeenBehavior& seen) {
  std::vector<std::size_t> likely(bodies_.size());
  std::iota(likely.begin(), likely.end(), std::size_t{0});
  const auto weight = [&](std::size_t i) {
    return kFading * bodies_[i].log_weight + std::max(likelihoods_[i], -kMostEvidence);
  };
  std::stable_sort(likely.begin(), likely.end(),
                   [&](std::size_t a, std::size_t b) { return weight(a) > weight(b); });
  const double best = weight(likely.front());
  for (std::size_t k = 0; k < std::min(likely.size(), kMostRefined); ++k) {
    if (weight(likely[k]) >= best - kWorthRefining) refine(seen, likely[k]);
  }
}

void BodyBelief::refine(const SeenBehavior& seen, std::size_t index) {
  BelievedBody& body = bodies_[index];
  if (imagined_[index].verdict == Verdict::kDiverged) return;
  const BodyMatrix root = squareRoot(body.covariance);
  // 1. How the end pose changes over one standard deviation.
  std::vector<Imagination::Question> questions;
  BelievedBody varied = body;
  for (int k = 0; k < 2 * kBodyParameters; ++k) {
    varied.mean = body.mean + (k % 2 == 0 ? 1.0 : -1.0) * root.col(k / 2);
    questions.push_back({physicsOf(varied), &body.state});
  }
  const std::vector<Imagined> around = imagination_->play(seen.genome, questions);
  Eigen::Matrix<double, 3, kBodyParameters> change, bend;
  for (int j = 0; j < kBodyParameters; ++j) {
    const Imagined &up = around[2 * j], &down = around[2 * j + 1];
    if (up.verdict == Verdict::kDiverged || down.verdict == Verdict::kDiverged) return;
    change.col(j) = 0.5 * difference(up.start_from_end, down.start_from_end);
    bend.col(j) = 0.5 * (difference(up.start_from_end, imagined_[index].start_from_end) +
                         difference(down.start_from_end, imagined_[index].start_from_end));
  }
  // 2. The update of an extended Kalman filter, in units of these deviations.
  const Pose2 measured = inverse(seen.world_from_before) * seen.world_from_after;
  // What is not linear is noise to a linear update: a square of a normal variable has variance 2.
  const Eigen::Matrix3d scatter = change * change.transpose() + 2.0 * bend * bend.transpose();
  const Eigen::Matrix3d inverse_covariance = (scatter + noise()).inverse();
  body.scatter = scatter;
  likelihoods_[index] = logLikelihood(seen, imagined_[index], body);
  if (body.misfit > kAccident) {
    body.covariance = 0.5 * (body.covariance + priorCovariance(share_));
    return;
  }
  const Eigen::Vector3d residual = difference(measured, imagined_[index].start_from_end);
  const BodyVector step = change.transpose() * (inverse_covariance * residual);
  // 3. The whole step, or half of it: what explains more and is less far from what was known.
  std::vector<BodyVector> steps = {step, 0.5 * step};
  questions.clear();
  for (const BodyVector& one : steps) {
    varied.mean = body.mean + root * one;
    questions.push_back({physicsOf(varied), &body.state});
  }
  const std::vector<Imagined> ahead = imagination_->play(seen.genome, questions);
  const Eigen::Matrix3d noise_and_bend = noise() + 2.0 * bend * bend.transpose();
  const auto cost = [&](const Imagined& imagined, const BodyVector& moved) {
    const Eigen::Vector3d left = difference(measured, imagined.start_from_end);
    return left.dot(noise_and_bend.inverse() * left) + moved.squaredNorm();
  };
  double least = cost(imagined_[index], BodyVector::Zero());
  BodyVector taken = BodyVector::Zero();
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (ahead[k].verdict == Verdict::kDiverged || cost(ahead[k], steps[k]) >= least) continue;
    least = cost(ahead[k], steps[k]);
    taken = steps[k];
    imagined_[index] = ahead[k];
  }
  body.mean += root * taken;
  const BodyMatrix kept = BodyMatrix::Identity() - change.transpose() * inverse_covariance * change;
  body.covariance = root * kept * root.transpose();
}

double BodyBelief::leastMisfit() const {
  double least = kAccident;
  for (const BelievedBody& body : bodies_) least = std::min(least, body.misfit);
  return least;
}

// Thinks everything likely that is possible, and judges the same behaviour again.
void BodyBelief::widen(const SeenBehavior& seen) {
  share_ = 1.0;
  for (BelievedBody& body : bodies_) {
    body.covariance = 0.5 * (body.covariance + priorCovariance(share_));
    body.scatter = priorScatter(share_);
  }
  imagined_.clear();
  likelihoods_.clear();
  imagineAll(seen, 0);
  refine(seen);
}

void BodyBelief::tryPairs(const SeenBehavior& seen) {
  const std::size_t first = bodies_.size();
  for (BelievedBody& pair : newPairs()) bodies_.push_back(std::move(pair));
  imagineAll(seen, first);
  keepBest(first, kMostSettled);
  settle(first);
  imagined_.resize(first);
  likelihoods_.resize(first);
  imagineAll(seen, first);
  for (std::size_t i = first; i < bodies_.size(); ++i) refine(seen, i);
  keepBest(firstPair(), kMostPairs);
}

// The single legs that explain most, each with any other leg, and legs that went the same way. They
// stand as the single leg's body does.
std::vector<BelievedBody> BodyBelief::newPairs() const {
  std::vector<const BelievedBody*> singles;
  for (const BelievedBody& body : bodies_) {
    if (legsOutOfOrder(body.legs) == 1) singles.push_back(&body);
  }
  std::stable_sort(
      singles.begin(), singles.end(),
      [](const BelievedBody* a, const BelievedBody* b) { return a->misfit < b->misfit; });
  std::vector<BelievedBody> pairs;
  const auto isKnown = [&](const std::vector<LegState>& legs) {
    const auto same = [&](const BelievedBody& body) { return body.legs == legs; };
    return std::any_of(pairs.begin(), pairs.end(), same) ||
           std::any_of(bodies_.begin(), bodies_.end(), same);
  };
  for (std::size_t k = 0; k < singles.size(); ++k) {
    for (std::size_t other = 0; other < singles[k]->legs.size(); ++other) {
      if (singles[k]->legs[other].condition != LegCondition::kIntact) continue;
      for (const LegCondition condition : kDamages) {
        BelievedBody pair = *singles[k];
        const LegState damaged{condition, {}};
        const bool alike =
            std::find(pair.legs.begin(), pair.legs.end(), damaged) != pair.legs.end();
        pair.legs[other] = damaged;
        if ((k >= kLegsToPair && !alike) || isKnown(pair.legs)) continue;
        pair.mean.setZero();
        pair.covariance = priorCovariance(kLikely);
        pair.scatter = priorScatter(kLikely);
        pair.log_prior = pair.log_weight = kTwoLegs;
        pairs.push_back(std::move(pair));
      }
    }
  }
  return pairs;
}

// Puts bodies from `first` on into the stand that is theirs; drops those that do not stand.
void BodyBelief::settle(std::size_t first) {
  std::vector<Physics> physics;
  for (std::size_t i = first; i < bodies_.size(); ++i) physics.push_back(physicsOf(bodies_[i]));
  const std::vector<std::optional<WorldState>> stands = imagination_->stands(physics);
  std::vector<BelievedBody> standing;
  for (std::size_t k = 0; k < stands.size(); ++k) {
    if (!stands[k]) continue;
    BelievedBody& body = bodies_[first + k];
    body.state = imagination_->turned(*stands[k], heading_rad_);
    standing.push_back(std::move(body));
  }
  bodies_.resize(first);
  std::move(standing.begin(), standing.end(), std::back_inserter(bodies_));
}

// Pairs stand behind the others until they are put in order.
std::size_t BodyBelief::firstPair() {
  std::vector<std::size_t> places(bodies_.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  const auto middle = std::stable_partition(places.begin(), places.end(), [&](std::size_t i) {
    return legsOutOfOrder(bodies_[i].legs) < 2;
  });
  const auto first = static_cast<std::size_t>(middle - places.begin());
  arrange(places);
  return first;
}

// Drops all but the `count` best from `first` on.
void BodyBelief::keepBest(std::size_t first, std::size_t count) {
  std::vector<std::size_t> places(bodies_.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  const auto weight = [&](std::size_t i) { return bodies_[i].log_weight + likelihoods_[i]; };
  std::stable_sort(places.begin() + static_cast<std::ptrdiff_t>(first), places.end(),
                   [&](std::size_t a, std::size_t b) { return weight(a) > weight(b); });
  places.resize(std::min(places.size(), first + count));
  arrange(places);
}

// Bodies and what was imagined of them, in the order of `places`; the others go.
void BodyBelief::arrange(const std::vector<std::size_t>& places) {
  std::vector<BelievedBody> bodies;
  std::vector<Imagined> imagined;
  std::vector<double> likelihoods;
  for (const std::size_t i : places) {
    bodies.push_back(std::move(bodies_[i]));
    imagined.push_back(std::move(imagined_[i]));
    likelihoods.push_back(likelihoods_[i]);
  }
  bodies_ = std::move(bodies);
  imagined_ = std::move(imagined);
  likelihoods_ = std::move(likelihoods);
}

void BodyBelief::order() {
  std::stable_sort(
      bodies_.begin(), bodies_.end(),
      [](const BelievedBody& a, const BelievedBody& b) { return a.log_weight > b.log_weight; });
  const double best = bodies_.front().log_weight;
  for (BelievedBody& body : bodies_) {
    body.log_weight = std::max(body.log_weight - best, kLeastWeight);
  }
}

// What is known of the parameters fades; bodies that nothing speaks for get what is known of the
// one that is believed, for they are of the same robot on the same floor.
void BodyBelief::forget() {
  const BelievedBody& best = bodies_.front();
  const bool sure = probability(0) > 0.9 && best.misfit < kFits;
  const BodyVector mean = best.mean;
  const BodyMatrix covariance = best.covariance;
  for (BelievedBody& body : bodies_) {
    if (sure && body.log_weight < -kWorthRefining) {
      body.mean = mean;
      body.covariance = covariance;
    }
    const BodyMatrix prior = priorCovariance(share_);
    body.covariance = (1.0 - kDrift) * body.covariance + kDrift * prior;
  }
}

}  // namespace hexapod
