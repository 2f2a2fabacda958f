#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include "hexapod_repertoire/WalkToAction.h"
#include "ros_interface/common/steady_action_server.h"
#include "ros_interface/planner/walker.h"

namespace hexapod {

/// The action walk_to. Its callbacks only hand on, so that a cancel waits for nothing.
class WalkToDoor {
 public:
  /// Both must outlive it.
  WalkToDoor(const ros::NodeHandle& node, ros::CallbackQueueInterface& queue, Walker& walker);

 private:
  using Server = SteadyActionServer<hexapod_repertoire::WalkToAction>;
  using Handle = Server::GoalHandle;

  void onGoal(Handle handle);

  Walker& walker_;
  Server server_;
};

}  // namespace hexapod
