#include "ros_interface/planner/twist_walk.h"

#include <algorithm>
#include <cmath>

namespace hexapod {
namespace {

// How often a robot that stands looks whether it may walk.
constexpr std::int64_t kLook_ns = kSecond_ns / 10;
// How much of the way is tried where all of it would touch.
constexpr double kShares[] = {1.0, 0.75, 0.5, 0.25};
// What leads there only so much better than standing still leads elsewhere.
constexpr double kOff = 0.5;

}  // namespace

Pose2 poseAfter(const Twist& twist, double duration_s, const Planner& planner, double part) {
  const double length_m = duration_s * std::hypot(twist.x_m_per_s, twist.y_m_per_s);
  const double turn_rad = duration_s * std::abs(twist.yaw_rad_per_s);
  double share = 1.0;
  if (length_m > planner.reach_m()) share = planner.reach_m() / length_m;
  if (turn_rad > planner.turn_rad()) share = std::min(share, planner.turn_rad() / turn_rad);
  const double time_s = part * share * duration_s;
  const double yaw_rad = twist.yaw_rad_per_s * time_s;
  // Straight on in the frame that turns with the robot: the chord, and half the turn.
  const double half_rad = yaw_rad / 2.0;
  const double chord_s = time_s * (std::abs(half_rad) < 1e-9 ? 1.0 : std::sin(half_rad) / half_rad);
  const Pose2 direction{0.0, 0.0, half_rad};
  const Pose2 end = direction * Pose2{twist.x_m_per_s * chord_s, twist.y_m_per_s * chord_s, 0.0};
  return {end.x_m, end.y_m, wrapAngle(yaw_rad)};
}

TwistWalk::TwistWalk(const WalkMeans& means, OpenGoal& goal,
                     std::shared_ptr<const AdaptivePlanner> planner)
    : means_(means),
      goal_(goal),
      planner_(std::move(planner)),
      obstacles_(means.obstacles),
      tally_(means.clock) {}

WalkReport TwistWalk::run() {
  awaitRest();
  while (!has_ended_) {
    const auto twist = goal_.ended() ? std::nullopt : goal_.request.twist();
    if (means_.newer_is_next()) {
      end(GoalCode::PREEMPTED, "A newer goal took over.");
    } else if (!twist) {
      end(GoalCode::SUCCEEDED, "The velocity ended.");
    } else if (const auto step = choose(*twist)) {
      told_ = false;
      play(*step);
    } else if (!has_ended_) {
      stand(*twist);
    }
  }
  return report_;
}

std::optional<PlannedStep> TwistWalk::choose(const Twist& twist) {
  const auto planner = planner_->planner();
  if (planner->usableEntries() == 0) {
    end(GoalCode::NO_REPERTOIRE, "No entry may be used.");
    return std::nullopt;
  }
  const auto obstacles = obstacles_.look();
  if (!obstacles) {
    return planner->nearestStep(
        poseAfter(twist, planner_->repertoire().behavior_duration_s, *planner));
  }
  const auto robot = standingPose();
  if (!robot) return std::nullopt;
  start_ = *robot;
  return chooseFree(twist, *planner, *obstacles);
}

std::optional<PlannedStep> TwistWalk::chooseFree(const Twist& twist, const Planner& planner,
                                                 const Obstacles& obstacles) const {
  const double duration_s = planner_->repertoire().behavior_duration_s;
  for (const double share : kShares) {
    const Pose2 wish = poseAfter(twist, duration_s, planner, share);
    const auto step = planner.nearestStep(wish);
    const bool leads_there =
        behaviorGap_m(step->world_from_end, wish) < kOff * behaviorGap_m(Pose2{}, wish);
    if ((share == 1.0 || leads_there) && planner.isFree(obstacles, start_, step->entry))
      return step;
  }
  return std::nullopt;
}

/// Nothing when the walk is over.
std::optional<Pose2> TwistWalk::standingPose() {
  const PoseReading robot = means_.poses.restPose(rest_, [this] { return isOver(); });
  if (!robot.pose && !isOver()) {
    end(GoalCode::POSE_LOST, "The walk by velocity ended, there is a map: " + robot.problem);
  }
  return robot.pose;
}

void TwistWalk::stand(const Twist& twist) {
  if (!told_) {
    means_.watcher.tellStanding(
        "The velocity leads into an obstacle of the map: the robot stands until the velocity "
        "changes or the way is free.");
  }
  told_ = true;
  const auto changes = [&] {
    const auto now = isOver() ? std::nullopt : goal_.request.twist();
    return !now || *now != twist || obstacles_.isOutdated() || means_.newer_is_next();
  };
  while (!means_.clock.waitUntil(means_.clock.steadyNow_ns() + kLook_ns, changes)) continue;
}

void TwistWalk::play(const PlannedStep& step) {
  const Repertoire& repertoire = planner_->repertoire();
  bool touches = false;
  const auto interrupted = [&] {
    touches = touches || obstacles_.touchesNews(*planner_->planner(), start_, step.entry);
    return touches || isOver();
  };
  const auto result = means_.player.play(
      {repertoire.entries.at(step.entry), repertoire.run_id, goal_.stops, interrupted});
  if (result.end != BehaviorPlayer::End::kPlayed && !interrupted()) {
    end(codeOf(result.end), "The walk by velocity ended: " + result.message);
    return;
  }
  ++report_.steps;
  if (touches) return awaitRest();
  noteEnd(result.finished);
}

void TwistWalk::awaitRest() {
  const auto ready = means_.player.awaitReady(goal_.stops, [this] { return isOver(); });
  if (ready.end == BehaviorPlayer::End::kPlayed) {
    noteEnd(ready.finished);
  } else if (!isOver()) {
    end(codeOf(ready.end), "The walk by velocity ended: " + ready.message);
  }
}

/// Of a behaviour, or of the way back from one.
void TwistWalk::noteEnd(const ros::Time& last_command) {
  rest_ = last_command + ros::Duration(means_.options.pose.pose_settle_s);
  const PoseReading robot = means_.poses.latest();
  if (robot.pose) tally_.noteRest(*robot.pose);
  report_.tally = tally_.tally();
  goal_.note(report_);
}

void TwistWalk::end(std::uint8_t code, const std::string& message) {
  report_.code = code;
  report_.message = message;
  report_.tally = tally_.tally();
  has_ended_ = true;
}

}  // namespace hexapod
