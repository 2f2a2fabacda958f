#pragma once

#include <nav_msgs/Path.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <cstdint>
#include <string>
#include <vector>

#include "planning/planner.h"
#include "ros_interface/display/markers.h"

namespace hexapod {

/// The path of a plan, a pose every 2 cm along its arcs, stamped now.
nav_msgs::Path pathOf(const Pose2& start, const PlanResult& plan, const std::string& frame);

/// Tells everybody of a walk: current_goal, plan, plan_markers (latched) and ~step_report.
/// Callable from any thread.
class WalkDisplay {
 public:
  /// `frame` is the frame of every pose that is published.
  WalkDisplay(ros::NodeHandle& node, ros::NodeHandle& private_node, const std::string& frame);

  void showGoal(const Pose2& goal);

  /// The plan from `start`, the poses measured after each behaviour so far, the goal's ring.
  void showPlan(const Pose2& start, const PlanResult& plan, const std::vector<Pose2>& walked,
                const Pose2& goal, double xy_tolerance_m);

  /// Behaviour `number` (from 1) of a goal: what was predicted and what was measured.
  void reportStep(const std::string& goal_id, std::uint32_t number, const PlannedStep& step,
                  const Pose2& before, const Pose2& after);

 private:
  std::string frame_;
  ros::Publisher plan_publisher_;
  ros::Publisher goal_publisher_;
  ros::Publisher marker_publisher_;
  ros::Publisher step_publisher_;
};

}  // namespace hexapod
