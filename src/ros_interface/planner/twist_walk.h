#pragma once

#include <functional>

#include "planning/adaptive_planner.h"
#include "ros_interface/planner/open_goal.h"

namespace hexapod {

/// What a walk by velocity needs of the node.
struct TwistMeans {
  BehaviorPlayer& player;
  std::function<bool()> newer_is_next;  ///< asked at rest: another goal takes over
};

/// Where a twist leads in `duration_s`, in the start frame. A twist faster than the repertoire
/// walks or turns is taken along the same arc, as far as it does.
Pose2 poseAfter(const Twist& twist, double duration_s, const Planner& planner);

/// Plays, again and again, the entry that leads nearest to the twist times its duration, as long as
/// the goal's twist says something and is not zero; then breaks off. So a new twist acts when the
/// behaviour under way has ended, a stop at once.
WalkReport walkByTwist(const TwistMeans& means, OpenGoal& goal, const AdaptivePlanner& planner);

}  // namespace hexapod
