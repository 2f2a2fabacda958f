#include "planning/plan_cost.h"

namespace hexapod {

Uncertainty Uncertainty::after(const Move& move, double kept) const {
  const double share = kept * kept;
  // A heading error e moves the end by e * (-y, x).
  const double swing_x_m = -move.end.y_m;
  const double swing_y_m = move.end.x_m;
  const double swung_m2 = heading_rad2 * move.length_m * move.length_m +
                          2.0 * (x_heading_m * swing_x_m + y_heading_m * swing_y_m);
  const double x = x_heading_m + heading_rad2 * swing_x_m;
  const double y = y_heading_m + heading_rad2 * swing_y_m;
  return {share * (position_m2 + swung_m2) + move.spread_m * move.spread_m,
          share * heading_rad2 + move.spread_rad * move.spread_rad,
          share * (move.cosine * x + move.sine * y), share * (move.cosine * y - move.sine * x)};
}

EndCost::EndCost(const GoalTolerance& tolerance, const PlannerOptions& options)
    : tolerance_(tolerance),
      margin_weight_(options.margin_weight),
      recovery_steps_(options.recovery_steps) {}

double EndCost::margin(double distance_m, double heading_rad) const {
  const double off = distance_m / tolerance_.xy_m;
  const double turned = tolerance_.anyHeading() ? 0.0 : heading_rad / tolerance_.yaw_rad;
  return 0.5 * margin_weight_ * (off * off + turned * turned);
}

double EndCost::operator()(double distance_m, double heading_rad,
                           const Uncertainty& uncertainty) const {
  // The variance of the position is that of both axes; only the axis towards the goal decides.
  const double position_miss =
      missProbability(distance_m, std::sqrt(0.5 * uncertainty.position_m2), tolerance_.xy_m);
  const double heading_miss =
      tolerance_.anyHeading()
          ? 0.0
          : missProbability(heading_rad, std::sqrt(uncertainty.heading_rad2), tolerance_.yaw_rad);
  const double miss = 1.0 - (1.0 - position_miss) * (1.0 - heading_miss);
  return recovery_steps_ * miss + margin(distance_m, heading_rad);
}

double missProbability(double offset, double deviation, double limit) {
  if (deviation <= 0.0) return offset > limit ? 1.0 : 0.0;
  const double scale = 1.0 / (std::sqrt(2.0) * deviation);
  return 0.5 * (std::erfc((limit - offset) * scale) + std::erfc((limit + offset) * scale));
}

}  // namespace hexapod
