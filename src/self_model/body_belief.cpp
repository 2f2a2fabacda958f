#include "self_model/body_belief.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "self_model/belief_prior.h"

namespace hexapod {
namespace {

// A behaviour's evidence fades by this per behaviour; no body is held less likely than kLeastWeight
// below the best.
constexpr double kFading = 0.9;
constexpr double kLeastWeight = -20.0;
// Bodies this far below the best are not refined, and not more than so many.
constexpr double kWorthRefining = 10.0;
constexpr std::size_t kMostRefined = 4;
// Misfits: fits well, and is not explained.
constexpr double kFits = 8.0;
constexpr double kUnexplained = 12.0;
// Bodies with two legs out of order that are kept; the best of many are worth settling.
constexpr std::size_t kMostPairs = 6;
constexpr std::size_t kMostSettled = 10;
// What is known of the parameters fades by this share of the prior per behaviour.
constexpr double kDrift = 0.02;

Physics levelAndIntact(Physics physics) {
  physics.legs.clear();
  physics.slope_x_rad = physics.slope_y_rad = 0.0;
  return physics;
}

double evidenceOf(const BelievedBody& body) {
  return std::max(body.log_likelihood, -kMostEvidence);
}

}  // namespace

BodyBelief::BodyBelief(std::shared_ptr<const Imagination> imagination, const Physics& nominal,
                       const BeliefOptions& options)
    : imagination_(std::move(imagination)),
      nominal_(nominal),
      evidence_(imagination_->robot(), options),
      refinement_(imagination_, nominal_, evidence_),
      share_(kLikely) {
  const std::vector<LegState> intact(imagination_->robot().legs.size());
  const std::vector<LegState> usual = nominal.legs.empty() ? intact : nominal.legs;
  add({usual}, 0.0);
  for (const BodyVector& mean : farOff()) add({usual}, kOtherwise, mean);
  std::vector<std::vector<LegState>> others = singleDamages(intact.size());
  others.push_back(intact);
  others.erase(std::remove(others.begin(), others.end(), usual), others.end());
  add(others, kOneLeg);
  checkThatSomeStand();
  order();
}

BodyBelief::BodyBelief(std::shared_ptr<const Imagination> imagination, const Physics& told)
    : imagination_(std::move(imagination)),
      nominal_(levelAndIntact(told)),
      evidence_(imagination_->robot(), BeliefOptions()),
      refinement_(imagination_, nominal_, evidence_),
      certain_(true) {
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
    body.stand = body.state = *stands[i];
    bodies_.push_back(std::move(body));
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
  imagineFrom(0, seen);
  if (!certain_) explain(seen);
  weigh(seen);
  order();
  if (!certain_) forget();
}

void BodyBelief::imagineFrom(std::size_t first, const SeenBehavior& seen) {
  std::vector<Imagination::Question> questions;
  for (std::size_t i = first; i < bodies_.size(); ++i) {
    questions.push_back({physicsOf(bodies_[i]), &bodies_[i].state});
  }
  std::vector<Imagined> answers = imagination_->play(seen.genome, questions, seen.jointsMatter());
  for (std::size_t i = first; i < bodies_.size(); ++i) {
    bodies_[i].imagined = std::move(answers[i - first]);
    evidence_.judge(seen, bodies_[i]);
  }
}

void BodyBelief::explain(const SeenBehavior& seen) {
  refineLikely(seen);
  if (leastMisfit() > kUnexplained) widen(seen);
  if (leastMisfit() > kUnexplained) tryPairs(seen);
}

void BodyBelief::refineLikely(const SeenBehavior& seen) {
  const auto weight = [](const BelievedBody& body) {
    return kFading * body.log_weight + evidenceOf(body);
  };
  std::vector<BelievedBody*> likely;
  for (BelievedBody& body : bodies_) likely.push_back(&body);
  std::stable_sort(likely.begin(), likely.end(), [&](const BelievedBody* a, const BelievedBody* b) {
    return weight(*a) > weight(*b);
  });
  const double best = weight(*likely.front());
  likely.resize(std::min(likely.size(), kMostRefined));
  for (BelievedBody* body : likely) {
    if (weight(*body) >= best - kWorthRefining) refinement_.refine(seen, share_, *body);
  }
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
  imagineFrom(0, seen);
  refineLikely(seen);
}

void BodyBelief::tryPairs(const SeenBehavior& seen) {
  const std::size_t first = bodies_.size();
  for (BelievedBody& pair : likelyPairs(bodies_)) bodies_.push_back(std::move(pair));
  imagineFrom(first, seen);
  keepBest(first, kMostSettled);
  settle(first, seen.world_from_before.yaw_rad);
  imagineFrom(first, seen);
  for (std::size_t i = first; i < bodies_.size(); ++i) refinement_.refine(seen, share_, bodies_[i]);
  // Those of earlier behaviours with them.
  const auto pairs =
      std::stable_partition(bodies_.begin(), bodies_.end(),
                            [](const BelievedBody& body) { return legsOutOfOrder(body.legs) < 2; });
  keepBest(static_cast<std::size_t>(pairs - bodies_.begin()), kMostPairs);
}

// Puts bodies from `first` on into the stand that is theirs; drops those that do not stand.
void BodyBelief::settle(std::size_t first, double heading_rad) {
  std::vector<Physics> physics;
  for (std::size_t i = first; i < bodies_.size(); ++i) physics.push_back(physicsOf(bodies_[i]));
  const std::vector<std::optional<WorldState>> stands = imagination_->stands(physics);
  std::vector<BelievedBody> standing;
  for (std::size_t k = 0; k < stands.size(); ++k) {
    if (!stands[k]) continue;
    standing.push_back(std::move(bodies_[first + k]));
    standing.back().stand = *stands[k];
    standing.back().state = imagination_->turned(*stands[k], heading_rad);
  }
  bodies_.resize(first);
  std::move(standing.begin(), standing.end(), std::back_inserter(bodies_));
}

// Drops all but the `count` best from `first` on.
void BodyBelief::keepBest(std::size_t first, std::size_t count) {
  std::stable_sort(bodies_.begin() + static_cast<std::ptrdiff_t>(first), bodies_.end(),
                   [](const BelievedBody& a, const BelievedBody& b) {
                     return a.log_weight + a.log_likelihood > b.log_weight + b.log_likelihood;
                   });
  bodies_.resize(std::min(bodies_.size(), first + count));
}

void BodyBelief::weigh(const SeenBehavior& seen) {
  for (BelievedBody& body : bodies_) {
    // Who asks what to expect next stands, whatever he fell into: this body is not his, or somebody
    // has stood him up.
    const bool lies =
        body.imagined.verdict == Verdict::kDiverged || body.imagined.verdict == Verdict::kFell;
    body.state =
        imagination_->turned(lies ? body.stand : body.imagined.end, seen.world_from_after.yaw_rad);
    body.log_weight =
        body.log_prior + kFading * (body.log_weight - body.log_prior) + evidenceOf(body);
  }
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
    body.covariance = (1.0 - kDrift) * body.covariance + kDrift * priorCovariance(share_);
  }
}

}  // namespace hexapod
