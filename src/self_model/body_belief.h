#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "self_model/believed_body.h"
#include "self_model/evidence.h"
#include "self_model/refinement.h"

namespace hexapod {

/// Which body the robot has, from what its behaviours did: a posterior over legs that are intact,
/// locked, lifted, limp or missing, each alternative with a normal distribution over what differs
/// by degrees (body.h).
///
/// Every behaviour is imagined in all bodies and judged (Evidence); the likely ones learn from it
/// (Refinement). Robots are thought to be nearly as they were learned; while no body explains what
/// was seen, larger differences are thought likely and then pairs of legs are tried. Evidence fades
/// and no body is ever ruled out, so that what breaks later, or is repaired, is noticed. Each body
/// carries the state in which its last behaviour left it, where the next one starts.
///
/// Deterministic, whatever the number of threads. Used by one thread at a time.
class BodyBelief {
 public:
  /// Begins with the body of `nominal`, the one learned for, at its stand, heading 0, as the likely
  /// one. Throws std::runtime_error when no body stands.
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
  void imagineFrom(std::size_t first, const SeenBehavior& seen);
  void explain(const SeenBehavior& seen);
  void refineLikely(const SeenBehavior& seen);
  double leastMisfit() const;
  void widen(const SeenBehavior& seen);
  void tryPairs(const SeenBehavior& seen);
  void settle(std::size_t first, double heading_rad);
  void keepBest(std::size_t first, std::size_t count);
  void weigh(const SeenBehavior& seen);
  void order();
  void forget();

  std::shared_ptr<const Imagination> imagination_;
  Physics nominal_;
  Evidence evidence_;
  Refinement refinement_;
  bool certain_ = false;
  double share_ = 1.0;  // of what is possible that is thought likely
  std::vector<BelievedBody> bodies_;
};

}  // namespace hexapod
