#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "self_model/body.h"
#include "self_model/imagination.h"

namespace hexapod {

/// How a belief judges what it sees.
struct BeliefOptions {
  double model_noise_m = 0.005;        ///< what simulation misses of an end pose, per axis
  double model_noise_rad = 0.015;      ///< and of its heading
  double measurement_noise_m = 0.0;    ///< of a measured position, per axis
  double measurement_noise_rad = 0.0;  ///< of a measured heading
  double joint_noise_rad = 0.1;        ///< of how far a joint was seen to move
};

/// One body that the robot may have, as far as it is known.
struct BelievedBody {
  std::vector<LegState> legs;  ///< one per leg
  BodyVector mean = BodyVector::Zero();
  BodyMatrix covariance = BodyMatrix::Zero();
  double log_prior = 0.0;
  double log_weight = 0.0;  ///< 0 for the most likely body
  WorldState state;  ///< in which it is thought to stand: footprint at the origin, its heading
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();  ///< of its last prediction, by the covariance
  double misfit = 0.0;  ///< squared Mahalanobis distance of what was measured last, 3 expected
};

/// What was walked, as a belief sees it.
struct SeenBehavior {
  Genome genome;
  Pose2 world_from_before, world_from_after;
  std::vector<JointRange> joints;  ///< as in WalkedStep
};

/// Which body the robot has, from what its behaviours did: a posterior over legs that are intact,
/// locked, lifted, limp or missing, each alternative with a normal distribution over what differs
/// by degrees (body.h).
///
/// Every behaviour is imagined in all bodies. The likely ones are linearised by how the end pose
/// changes over a standard deviation of each direction of their covariance, and updated as in an
/// extended Kalman filter, by the end pose; likelihoods are cut, so that one accident decides
/// little. Robots are thought to be nearly as they were learned; while no body explains what was
/// seen, larger differences are thought likely and then pairs of legs are tried. Evidence fades and
/// no body is ever ruled out, so that what breaks later, or is repaired, is noticed. Each body
/// carries the state in which its last behaviour left it, where the next one starts.
///
/// Deterministic, whatever the number of threads. Used by one thread at a time.
class BodyBelief {
 public:
  /// Begins with an intact robot at its stand, heading 0, as the likely one. Throws
  /// std::runtime_error when no body stands.
  BodyBelief(std::shared_ptr<const Imagination> imagination, const Physics& nominal,
             const BeliefOptions& options);

  /// A robot that has this body, for sure.
  BodyBelief(std::shared_ptr<const Imagination> imagination, const Physics& told);

  void observe(const SeenBehavior& seen);

  /// Most likely first; never empty.
  const std::vector<BelievedBody>& bodies() const { return bodies_; }

  /// Of bodies()[i].
  double probability(std::size_t i) const;

  Physics physicsOf(const BelievedBody& body) const {
    return hexapod::physicsOf(nominal_, body.legs, body.mean);
  }

 private:
  void add(const std::vector<std::vector<LegState>>& bodies, double log_prior,
           const BodyVector& mean = BodyVector::Zero());
  void checkThatSomeStand() const;
  void addOtherwise(const std::vector<LegState>& intact);
  void imagineAll(const SeenBehavior& seen, std::size_t first);
  void refine(const SeenBehavior& seen);
  void refine(const SeenBehavior& seen, std::size_t index);
  double leastMisfit() const;
  void widen(const SeenBehavior& seen);
  void tryPairs(const SeenBehavior& seen);
  std::vector<BelievedBody> newPairs() const;
  void settle(std::size_t first);
  std::size_t firstPair();
  void keepBest(std::size_t first, std::size_t count);
  void arrange(const std::vector<std::size_t>& places);
  void forget();
  void order();
  double logLikelihood(const SeenBehavior& seen, const Imagined& imagined,
                       BelievedBody& body) const;
  double evidenceOfJoints(const SeenBehavior& seen, const Imagined& imagined,
                          const std::vector<LegState>& legs) const;
  Eigen::Matrix3d noise() const;

  std::shared_ptr<const Imagination> imagination_;
  Physics nominal_;
  BeliefOptions options_;
  bool certain_ = false;
  double share_ = 1.0;        // of what is possible that is thought likely
  double heading_rad_ = 0.0;  // in which the behaviour under way began
  std::vector<BelievedBody> bodies_;
  std::vector<Imagined> imagined_;   // of the behaviour under way, one per body
  std::vector<double> likelihoods_;  // log, of the same
};

}  // namespace hexapod
