#pragma once

#include <memory>
#include <optional>

#include "planning/adaptive_planner.h"
#include "ros_interface/planner/obstacle_watch.h"
#include "ros_interface/planner/open_goal.h"
#include "ros_interface/planner/tally_keeper.h"
#include "ros_interface/planner/walk_means.h"

namespace hexapod {

/// Where a twist leads in `duration_s`, in the start frame. A twist faster than the repertoire
/// walks or turns is taken along the same arc, as far as it does; of that, `part` (0 .. 1).
Pose2 poseAfter(const Twist& twist, double duration_s, const Planner& planner, double part = 1.0);

/// A walk by velocity: plays, again and again, the entry that leads nearest to the twist times its
/// duration, as long as the goal's twist says something and is not zero; then breaks off. So a new
/// twist acts when the behaviour under way has ended, a stop at once.
///
/// With obstacles, one that leads less far along the twist when that one would touch something.
/// When they all would the robot stands, which is told once, until the twist or the obstacles
/// change; one under way is broken off when it would touch what a new map shows. Used by one
/// thread, once.
class TwistWalk {
 public:
  TwistWalk(const WalkMeans& means, OpenGoal& goal, std::shared_ptr<const AdaptivePlanner> planner);

  /// Walks until the twist ends or the walk has ended otherwise.
  WalkReport run();

 private:
  /// The entry to play; nothing when none may be. A problem ends the walk.
  std::optional<PlannedStep> choose(const Twist& twist);
  std::optional<PlannedStep> chooseFree(const Twist& twist, const Planner& planner,
                                        const Obstacles& obstacles) const;
  std::optional<Pose2> standingPose();
  /// Until the twist or the obstacles change.
  void stand(const Twist& twist);
  void play(const PlannedStep& step);
  /// Until the robot stands.
  void awaitRest();
  void noteEnd(const ros::Time& last_command);
  bool isOver() const { return goal_.ended() || !goal_.request.twist(); }
  void end(std::uint8_t code, const std::string& message);

  const WalkMeans means_;
  OpenGoal& goal_;
  const std::shared_ptr<const AdaptivePlanner> planner_;
  ObstacleWatch obstacles_;
  TallyKeeper tally_;
  WalkReport report_;
  bool has_ended_ = false;
  bool told_ = false;  // that it stands
  ros::Time rest_;     // when the robot has come to rest
  Pose2 start_;        // of the behaviour under way, where there are obstacles
};

}  // namespace hexapod
