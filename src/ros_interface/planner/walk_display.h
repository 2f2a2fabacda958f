#pragma once

#include <nav_msgs/Path.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <visualization_msgs/MarkerArray.h>

#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "ros_interface/common/clock.h"
#include "ros_interface/display/plan_markers.h"
#include "ros_interface/planner/walk_watcher.h"

namespace hexapod {

/// The path of a plan, a pose every 2 cm along its arcs.
nav_msgs::Path pathOf(const Pose2& start, const PlanResult& plan, const std::string& frame,
                      const ros::Time& stamp);

/// What a plan found, for an answer: its path, its summary, where it ends or else the nearest pose.
void fillIn(const Pose2& start, const PlanResult& plan, const std::string& frame,
            const ros::Time& stamp, WalkReport& report);

/// Tells everybody of walks: current_goal, plan, plan_markers (latched), ~step_report and
/// ~walk_summary.
class WalkDisplay : public WalkWatcher {
 public:
  struct Sources {
    std::string frame;                    ///< of every pose that is published
    std::function<std::string()> belief;  ///< what is believed of the body, in words; may be empty
    std::string base_frame;               ///< the robot's, of its footprint
    Footprint footprint;                  ///< empty: not known
  };

  /// The clock must outlive it.
  WalkDisplay(ros::NodeHandle& node, ros::NodeHandle& private_node, const Clock& clock,
              Sources sources);

  void showGoal(const Pose2& goal) override;
  void showPlan(const Pose2& start, const PlanResult& plan, const std::vector<WalkedStop>& walked,
                const Pose2& goal, double xy_tolerance_m) override;
  void showRefused(const Pose2& goal, double xy_tolerance_m, const WalkReport& report) override;
  void reportStep(const std::string& goal_id, std::uint32_t number, const PlannedStep& step,
                  const Pose2& before, const Pose2& after) override;
  void reportWalk(const std::string& goal_id, const WalkReport& report) override;
  void tellStanding(const std::string& why) override;

 private:
  const Clock& clock_;
  std::string frame_;
  visualization_msgs::MarkerArray footprint_;  // none or one
  std::mutex mutex_;
  visualization_msgs::MarkerArray plan_;  // that was shown last; guarded by mutex_
  std::function<std::string()> belief_;
  ros::Publisher plan_publisher_;
  ros::Publisher goal_publisher_;
  ros::Publisher marker_publisher_;
  ros::Publisher step_publisher_;
  ros::Publisher summary_publisher_;
};

}  // namespace hexapod
