#include "planning/steps_to_go.h"

#include <algorithm>
#include <limits>

namespace hexapod {
namespace {

// Stand for "cannot", small enough that all estimates stay finite and ordered.
constexpr double kNoReach_m = 1e-3;
constexpr double kNoTurn_rad = 1e-2;

// Nearer than this the direction of the goal says little about the turning it takes.
constexpr double kNear_m = 0.15;

}  // namespace

StepsToGo::StepsToGo(const std::vector<Move>& moves)
    : forward_m_(kNoReach_m),
      backward_m_(kNoReach_m),
      left_rad_(kNoTurn_rad),
      right_rad_(kNoTurn_rad) {
  for (const Move& move : moves) {
    reach_m_ = std::max(reach_m_, move.length_m);
    double& reach = move.end.x_m < 0.0 ? backward_m_ : forward_m_;
    reach = std::max(reach, move.length_m);
    double& turn = move.end.yaw_rad < 0.0 ? right_rad_ : left_rad_;
    turn = std::max(turn, std::abs(move.end.yaw_rad));
  }
}

double StepsToGo::turning(double angle_rad) const {
  const double left_rad = angle_rad < 0.0 ? angle_rad + 2.0 * M_PI : angle_rad;
  return std::min(left_rad / left_rad_, (2.0 * M_PI - left_rad) / right_rad_);
}

double StepsToGo::operator()(const Pose2& start_from_goal, bool any_heading) const {
  return (*this)(
      Ahead{std::hypot(start_from_goal.x_m, start_from_goal.y_m),
            std::atan2(start_from_goal.y_m, start_from_goal.x_m), 0.0, start_from_goal.yaw_rad},
      any_heading);
}

double StepsToGo::operator()(const WayField& ways, const Pose2& world_from_robot,
                             double goal_heading_rad, bool any_heading) const {
  const auto way = ways.wayFrom(world_from_robot.x_m, world_from_robot.y_m);
  if (!way) return std::numeric_limits<double>::infinity();
  return (*this)({way->length_m, wrapAngle(way->direction_rad - world_from_robot.yaw_rad),
                  wrapAngle(way->arrival_rad - way->direction_rad), goal_heading_rad},
                 any_heading);
}

double StepsToGo::operator()(const Ahead& ahead, bool any_heading) const {
  const double weight = std::min(1.0, ahead.length_m / kNear_m);
  const auto driving = [&](double towards_rad, double reach_m) {
    const double first_turn_rad = weight * towards_rad;
    const double last_turn_rad =
        any_heading ? 0.0 : wrapOnce(wrapOnce(ahead.heading_rad - first_turn_rad) - ahead.bend_rad);
    return ahead.length_m / reach_m + turning(first_turn_rad) + turning(last_turn_rad);
  };
  return std::min(driving(ahead.direction_rad, forward_m_),
                  driving(wrapOnce(ahead.direction_rad + M_PI), backward_m_));
}

}  // namespace hexapod
