#pragma once

#include <string>

#include "geometry/pose2.h"

namespace hexapod {

/// How a simulated behaviour ended. Only kWalked has an end pose.
enum class Verdict {
  kWalked,
  kFell,          ///< body touched the floor, left the allowed height or was upside down
  kSelfCollided,  ///< two legs touched
  kDiverged       ///< the simulation blew up: a pose or velocity was not finite or absurd
};

/// "walked", "fell", "self-collided", "diverged".
std::string toString(Verdict verdict);

/// What a behaviour leads to.
struct Outcome {
  Verdict verdict = Verdict::kDiverged;
  Pose2 end_pose;  ///< start_from_end footprint; only when walked
  /// What local competition compares, >= 0, lower is better; only when walked. The orientation
  /// error of the end pose [rad], as in the paper, unless an evaluator adds to it (see
  /// RobustEvaluator).
  double cost = 0.0;

  bool walked() const { return verdict == Verdict::kWalked; }
};

/// A walked outcome, its cost the orientation error. Coordinates are rounded to 1e-5 m and 1e-5
/// rad, so that ties between mirrored or equal gaits are ties on every machine. A pose that is not
/// finite is kDiverged.
Outcome walkedTo(const Pose2& start_from_end);

}  // namespace hexapod
