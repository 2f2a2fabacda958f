#include "geometry/arc.h"

#include <cmath>

namespace hexapod {

Pose2 Arc::at(double fraction) const {
  const double travelled = fraction * length_m;
  const double turned = curvature_per_m * travelled;
  // sin(a)/a and (1 - cos(a))/a by series near zero, where the quotient loses its digits.
  const bool straight = std::abs(turned) < 1e-4;
  const double sine_quotient = straight ? 1.0 - turned * turned / 6.0 : std::sin(turned) / turned;
  const double cosine_quotient = straight ? turned / 2.0 : (1.0 - std::cos(turned)) / turned;
  return {travelled * sine_quotient, travelled * cosine_quotient, wrapAngle(turned)};
}

Arc arcThrough(double x_m, double y_m) {
  const double squared = x_m * x_m + y_m * y_m;
  if (squared == 0.0) return {};
  Arc arc;
  arc.curvature_per_m = 2.0 * y_m / squared;
  const double direction = x_m < 0.0 ? -1.0 : 1.0;
  const double half_turn = std::atan2(direction * y_m, direction * x_m);
  arc.heading_rad = wrapAngle(2.0 * half_turn);
  // chord = 2 R sin(half turn), length = 2 R half turn.
  const double ratio = std::abs(half_turn) < 1e-4 ? 1.0 + half_turn * half_turn / 6.0
                                                  : half_turn / std::sin(half_turn);
  arc.length_m = direction * std::sqrt(squared) * ratio;
  return arc;
}

double orientationError(const Pose2& start_from_end) {
  const Arc arc = arcThrough(start_from_end.x_m, start_from_end.y_m);
  return std::abs(wrapAngle(start_from_end.yaw_rad - arc.heading_rad));
}

}  // namespace hexapod
