#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "planning/walk.h"
#include "ros_interface/planner/obstacle_watch.h"
#include "ros_interface/planner/open_goal.h"
#include "ros_interface/planner/tally_keeper.h"
#include "ros_interface/planner/walk_means.h"

namespace hexapod {

/// The walk to one goal: measure, plan, have one behaviour played, report, again. Breaks off soon
/// after the goal has ended. Used by one thread, once.
class WalkRun {
 public:
  WalkRun(const WalkMeans& means, OpenGoal& goal, std::shared_ptr<AdaptivePlanner> planner);

  /// Walks until the goal is reached or the walk has ended otherwise.
  WalkReport run();

 private:
  /// Waits until the robot stands. False when the walk has ended.
  bool awaitRest();
  ros::Time restAfter(const ros::Time& last_command) const;
  /// Reads where the robot came to rest. False when the walk has ended.
  bool measure();
  /// Decides what to do there, with the obstacles of now.
  Walk::Decision decide();
  /// The same, while obstacles close every way, until they open or blocked_retry_s is over.
  Walk::Decision decideOnceOpen();
  /// Plans from there. The behaviour to play, nothing when the walk has ended.
  std::optional<PlannedStep> plan();
  /// Has it played. False when the walk has ended.
  bool play(const PlannedStep& step);
  /// While a behaviour is played: true to break it off.
  bool isToBreakOff();
  /// While the robot moves: notes where it is. True when it has not been seen for too long, which
  /// ends the walk.
  bool isLost();
  void noteWhereRobotIs(const Pose2& robot);
  void end(std::uint8_t code, const std::string& message);

  const WalkMeans means_;
  OpenGoal& goal_;
  std::shared_ptr<AdaptivePlanner> planner_;
  const std::vector<Waypoint> route_;
  Walk walk_;
  WalkReport report_;
  ros::Time rest_;                     // when the robot has come to rest
  std::vector<WalkedStop> walked_;     // the newest last
  std::optional<PlannedStep> played_;  // the last behaviour, if it was played as it is
  TallyKeeper tally_;
  ObstacleWatch obstacles_;
  std::size_t entry_ = 0;  // of the behaviour under way
  bool touches_ = false;   // it is broken off as it would touch something new
};

}  // namespace hexapod
