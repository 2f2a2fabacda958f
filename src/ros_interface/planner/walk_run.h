#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "planning/walk.h"
#include "ros_interface/display/walk_display.h"
#include "ros_interface/planner/behavior_client.h"
#include "ros_interface/planner/planner_node_options.h"
#include "ros_interface/planner/pose_source.h"
#include "ros_interface/planner/walk_goal.h"

namespace hexapod {

/// The walk to one goal: measure, plan, have one behaviour executed, report, again. Used by one
/// thread, once.
class WalkRun {
 public:
  /// What a walk needs of the node; all of it must outlive the walk.
  struct Means {
    const PlannerNodeOptions& options;
    const PoseSource& poses;
    BehaviorClient& executor;
    WalkDisplay& display;
    std::function<bool()> interrupted;         ///< true: break off at once
    std::function<std::string()> reasonToEnd;  ///< at rest: a sentence, or empty to go on
  };

  WalkRun(const Means& means, const WalkGoal& goal, std::shared_ptr<AdaptivePlanner> planner);

  /// Walks until the goal is reached or the walk has ended otherwise.
  WalkReport run();

 private:
  /// Reads where the robot came to rest. False when the walk has ended.
  bool measure();
  /// Plans from there. The behaviour to play, nothing when the walk has ended.
  std::optional<PlannedStep> plan();
  /// Has the executor play it. False when the walk has ended.
  bool play(const PlannedStep& step);
  void end(std::uint8_t code, const std::string& message);

  Means means_;
  const WalkGoal& goal_;
  std::shared_ptr<AdaptivePlanner> planner_;
  Walk walk_;
  WalkReport report_;
  ros::Time rest_{0};                  // when the robot came to rest after the last behaviour
  std::vector<Pose2> walked_;          // measured, the newest last
  std::optional<PlannedStep> played_;  // the last behaviour, if it was played to its end
};

}  // namespace hexapod
