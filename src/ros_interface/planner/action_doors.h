#pragma once

#include <move_base_msgs/MoveBaseAction.h>
#include <ros/callback_queue_interface.h>
#include <ros/node_handle.h>

#include "hexapod_repertoire/WalkRouteAction.h"
#include "hexapod_repertoire/WalkToAction.h"
#include "ros_interface/planner/action_door.h"
#include "ros_interface/planner/walker.h"

namespace hexapod {

/// The actions walk_to, walk_route, and move_base for clients that know that one: the code and the
/// sentence of its end are in the status text.
class ActionDoors {
 public:
  /// Both must outlive it.
  ActionDoors(const ros::NodeHandle& node, ros::CallbackQueueInterface& queue, Walker& walker);

 private:
  ActionDoor<hexapod_repertoire::WalkToAction> walk_to_;
  ActionDoor<hexapod_repertoire::WalkRouteAction> walk_route_;
  ActionDoor<move_base_msgs::MoveBaseAction> move_base_;
};

}  // namespace hexapod
