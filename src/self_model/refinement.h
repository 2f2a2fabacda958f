#pragma once

#include <memory>
#include <optional>

#include "self_model/evidence.h"

namespace hexapod {

/// Learns from one behaviour what differs by degrees in a body, as in an extended Kalman filter:
/// the behaviour is imagined once more a standard deviation to either side of each direction of
/// what is known, and what bends over those deviations counts as noise. The whole step or half of
/// it is taken, whichever explains more. Immutable.
class Refinement {
 public:
  Refinement(std::shared_ptr<const Imagination> imagination, const Physics& nominal,
             const Evidence& evidence);

  /// `body` has imagined the behaviour. `share`: of what is possible that is thought likely.
  void refine(const SeenBehavior& seen, double share, BelievedBody& body) const;

 private:
  using Jacobian = Eigen::Matrix<double, 3, kBodyParameters>;

  /// How the end pose changes over one standard deviation of each direction, and bends.
  struct Slope {
    BodyMatrix root;  ///< of the covariance: the directions
    Jacobian change, bend;
  };

  std::optional<Slope> slopeAt(const SeenBehavior& seen, const BelievedBody& body) const;
  std::vector<Imagined> imagineAt(const SeenBehavior& seen, const BelievedBody& body,
                                  const std::vector<BodyVector>& means,
                                  Imagination::Joints joints) const;
  void step(const SeenBehavior& seen, const Slope& slope, BelievedBody& body) const;

  std::shared_ptr<const Imagination> imagination_;
  Physics nominal_;
  Evidence evidence_;
};

}  // namespace hexapod
