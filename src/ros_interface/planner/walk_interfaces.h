#pragma once

#include <actionlib/server/action_server.h>
#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/GetPlan.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <std_srvs/Trigger.h>

#include <string>

#include "hexapod_repertoire/GoTo.h"
#include "hexapod_repertoire/WalkToAction.h"
#include "ros_interface/planner/walker.h"

namespace hexapod {

/// The ways to send the robot somewhere: service go_to, action walk_to, topic
/// move_base_simple/goal (rviz), make_plan (plan only) and ~cancel. All lead to one Walker.
///
/// Calls that wait for the end of a walk have threads of their own, so that they hold up nothing.
class WalkInterfaces {
 public:
  WalkInterfaces(ros::NodeHandle& node, ros::NodeHandle& private_node, Walker& walker,
                 const PlannerNodeOptions& options);

 private:
  using WalkServer = actionlib::ActionServer<hexapod_repertoire::WalkToAction>;
  using WalkHandle = WalkServer::GoalHandle;
  struct Asked {  // a goal as a client sent it
    geometry_msgs::PoseStamped pose;
    double xy_tolerance_m = 0.0;
    double yaw_tolerance_rad = 0.0;
  };

  /// Reads, checks and plans a goal. The report is a refusal unless its code is SUCCEEDED.
  WalkReport examine(const Asked& asked, WalkGoal& goal) const;

  bool goTo(hexapod_repertoire::GoTo::Request& request,
            hexapod_repertoire::GoTo::Response& response);
  bool makePlan(nav_msgs::GetPlan::Request& request, nav_msgs::GetPlan::Response& response);
  bool cancel(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  void simpleGoal(const geometry_msgs::PoseStamped::ConstPtr& message);
  void actionGoal(WalkHandle handle);
  void actionCancel(WalkHandle handle);

  Walker& walker_;
  PlannerNodeOptions options_;
  ros::CallbackQueue waiting_queue_;
  ros::ServiceServer go_to_;
  ros::ServiceServer make_plan_;
  ros::ServiceServer cancel_;
  ros::Subscriber simple_goal_;
  WalkServer action_;
  ros::AsyncSpinner waiting_spinner_;
};

}  // namespace hexapod
