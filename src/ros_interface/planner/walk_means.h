#pragma once

#include <functional>

#include "ros_interface/common/clock.h"
#include "ros_interface/planner/planner_node_options.h"
#include "ros_interface/planner/walk_goal.h"
#include "ros_interface/planner/walk_watcher.h"
#include "ros_interface/robot_client/behavior_player.h"
#include "ros_interface/robot_client/pose_source.h"

namespace hexapod {

/// What a walk needs of the node; all of it must outlive the walk.
struct WalkMeans {
  const PlannerNodeOptions& options;
  const Clock& clock;
  const PoseSource& poses;
  BehaviorPlayer& player;
  WalkWatcher& watcher;
  std::function<bool()> newer_is_next;  ///< asked at rest: another goal takes over
  ObstacleSource obstacles = {};        ///< may be empty
};

/// `stop`, or that so many plans begun now have taken planning_wall_time_s each. The clock must
/// outlive it.
std::function<bool()> withinWallTime(const PlannerNodeOptions& options, const Clock& clock,
                                     std::function<bool()> stop, std::size_t plans = 1);

}  // namespace hexapod
