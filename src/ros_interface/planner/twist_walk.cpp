#include "ros_interface/planner/twist_walk.h"

#include <algorithm>
#include <cmath>

namespace hexapod {
namespace {

WalkReport reportOf(std::uint8_t code, const std::string& message, std::uint32_t steps) {
  WalkReport report;
  report.code = code;
  report.message = message;
  report.steps = steps;
  return report;
}

}  // namespace

Pose2 poseAfter(const Twist& twist, double duration_s, const Planner& planner) {
  const double length_m = duration_s * std::hypot(twist.x_m_per_s, twist.y_m_per_s);
  const double turn_rad = duration_s * std::abs(twist.yaw_rad_per_s);
  double share = 1.0;
  if (length_m > planner.reach_m()) share = planner.reach_m() / length_m;
  if (turn_rad > planner.turn_rad()) share = std::min(share, planner.turn_rad() / turn_rad);
  const double time_s = share * duration_s;
  const double yaw_rad = twist.yaw_rad_per_s * time_s;
  // Straight on in the frame that turns with the robot: the chord, and half the turn.
  const double half_rad = yaw_rad / 2.0;
  const double chord_s = time_s * (std::abs(half_rad) < 1e-9 ? 1.0 : std::sin(half_rad) / half_rad);
  const Pose2 direction{0.0, 0.0, half_rad};
  const Pose2 end = direction * Pose2{twist.x_m_per_s * chord_s, twist.y_m_per_s * chord_s, 0.0};
  return {end.x_m, end.y_m, wrapAngle(yaw_rad)};
}

WalkReport walkByTwist(const TwistMeans& means, OpenGoal& goal, const AdaptivePlanner& planner) {
  const Repertoire& repertoire = planner.repertoire();
  const auto interrupted = [&goal] { return goal.ended() || !goal.request.twist(); };
  for (std::uint32_t steps = 0;; ++steps) {
    if (means.newer_is_next())
      return reportOf(GoalCode::PREEMPTED, "A newer goal took over.", steps);
    const auto twist = goal.ended() ? std::nullopt : goal.request.twist();
    if (!twist) return reportOf(GoalCode::SUCCEEDED, "The velocity ended.", steps);
    const auto now = planner.planner();
    const auto step = now->nearestStep(poseAfter(*twist, repertoire.behavior_duration_s, *now));
    if (!step) return reportOf(GoalCode::NO_REPERTOIRE, "No entry may be used.", steps);
    const auto result = means.player.play(
        {repertoire.entries.at(step->entry), repertoire.run_id, goal.stops, interrupted});
    if (result.end != BehaviorPlayer::End::kPlayed && !interrupted()) {
      return reportOf(codeOf(result.end), "The walk by velocity ended: " + result.message, steps);
    }
  }
}

}  // namespace hexapod
