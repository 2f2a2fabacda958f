#pragma once

#include <nav_msgs/GetPlan.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>
#include <std_srvs/Trigger.h>

#include "hexapod_repertoire/GoTo.h"
#include "ros_interface/planner/walker.h"

namespace hexapod {

/// The services go_to, make_plan (also as move_base/make_plan) and ~cancel, and the topic
/// move_base_simple/goal (rviz).
///
/// Calls that wait, for the end of a walk or for a plan, have threads of their own, so that they
/// hold up nothing; a cancel is served by the queue it is given.
class ServiceDoors {
 public:
  /// The references must outlive it.
  ServiceDoors(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
               ros::CallbackQueueInterface& cancel_queue, Walker& walker);

 private:
  bool goTo(hexapod_repertoire::GoTo::Request& request,
            hexapod_repertoire::GoTo::Response& response);
  bool makePlan(nav_msgs::GetPlan::Request& request, nav_msgs::GetPlan::Response& response);
  bool cancel(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  void simpleGoal(const geometry_msgs::PoseStamped::ConstPtr& message);

  Walker& walker_;
  ros::CallbackQueue walk_queue_;
  ros::CallbackQueue plan_queue_;
  ros::ServiceServer go_to_;
  ros::ServiceServer make_plan_;
  ros::ServiceServer move_base_make_plan_;
  ros::ServiceServer cancel_;
  ros::Subscriber simple_goal_;
  ros::AsyncSpinner walk_spinner_;
  ros::AsyncSpinner plan_spinner_;
};

}  // namespace hexapod
