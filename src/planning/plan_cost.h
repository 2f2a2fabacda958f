#pragma once

#include "planning/move.h"

namespace hexapod {

/// Covariance of the pose error after a chain of moves, in the frame of its end, to first order. Of
/// the position only what decides: the variance of both axes together.
struct Uncertainty {
  double position_m2 = 0.0;   ///< variance of x plus variance of y
  double heading_rad2 = 0.0;  ///< variance
  double x_heading_m = 0.0;   ///< covariance of x and heading [m rad]
  double y_heading_m = 0.0;   ///< covariance of y and heading [m rad]

  /// After one more move: its own spread, and what the earlier heading error does over its length.
  /// `kept` is the share of the earlier standard deviation that remains: 1 when walked blindly,
  /// less when every move is planned anew from the measured pose.
  Uncertainty after(const Move& move, double kept) const;
};

/// Share of an earlier error that planning anew from the measured pose does not remove: with the
/// entries some 2 cm apart the next best ones make up for about half of it.
constexpr double kKeptWhenReplanned = 0.5;

/// Price of a predicted end, in behaviours.
///
/// recovery_steps * P(end outside the tolerance) + margin_weight * (mean square of distance and
/// heading error, each as a share of its tolerance). The first term trades a chain that may just
/// miss against a longer one that will not; the second prefers the centre among chains that are
/// equally sure.
class EndCost {
 public:
  EndCost(const GoalTolerance& tolerance, const PlannerOptions& options);

  /// The second term, which is also a lower bound of the sum. Errors >= 0, in metres and radians.
  double margin(double distance_m, double heading_rad) const;
  /// Both terms.
  double operator()(double distance_m, double heading_rad, const Uncertainty& uncertainty) const;

 private:
  GoalTolerance tolerance_;
  double margin_weight_;
  double recovery_steps_;
};

/// Probability that a normal error of the given standard deviation (>= 0) around `offset` (>= 0)
/// leaves [-limit, limit]. With a deviation of 0: 0 or 1.
double missProbability(double offset, double deviation, double limit);

}  // namespace hexapod
