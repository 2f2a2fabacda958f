#pragma once

#include <ros/callback_queue_interface.h>
#include <ros/node_handle.h>

#include <string>

#include "ros_interface/common/steady_action_server.h"
#include "ros_interface/planner/walker.h"

namespace hexapod {

/// An action that leads to the walker. Its callbacks only hand on, so that a cancel waits for
/// nothing.
///
/// A goal that ends unaccepted is rejected, unless it was cancelled or overtaken: that is PREEMPTED
/// whenever it happens.
template <class Action>
class ActionDoor {
 public:
  using Server = SteadyActionServer<Action>;
  using Handle = typename Server::GoalHandle;

  /// How this action says what the walker says.
  struct Words {
    GoalRequest (*request)(const typename Server::Goal& goal);
    typename Server::Result (*result)(const WalkReport& report);
    typename Server::Feedback (*feedback)(const WalkProgress& progress);
  };

  /// Queue and walker must outlive it.
  ActionDoor(const ros::NodeHandle& node, ros::CallbackQueueInterface& queue, Walker& walker,
             const std::string& name, const Words& words)
      : walker_(walker),
        words_(words),
        server_(
            node, name, queue, [this](Handle handle) { onGoal(handle); },
            [this](Handle handle) { walker_.cancel(handle.getGoalID().id); },
            words.result(cancelledEarly())) {
    server_.start();
  }

 private:
  using Status = actionlib_msgs::GoalStatus;

  void onGoal(Handle handle) {
    GoalListener listener;
    listener.accepted = [handle](const WalkReport&) mutable { handle.setAccepted(); };
    listener.progress = [this, handle](const WalkProgress& progress) mutable {
      handle.publishFeedback(words_.feedback(progress));
    };
    listener.ended = [this, handle](const WalkReport& report) mutable { end(handle, report); };
    GoalRequest request = words_.request(*handle.getGoal());
    request.sent = handle.getGoalID().stamp;
    walker_.submit(request, listener, handle.getGoalID().id);
  }

  void end(Handle& handle, const WalkReport& report) const {
    const std::uint8_t status = handle.getGoalStatus().status;
    const bool waits = status == Status::PENDING || status == Status::RECALLING;
    const auto result = words_.result(report);
    if (report.code == GoalCode::PREEMPTED) {
      // actionlib knows PREEMPTED of accepted goals only.
      if (waits) handle.setAccepted();
      handle.setCanceled(result, report.message);
    } else if (waits) {
      handle.setRejected(result, report.message);
    } else if (report.success()) {
      handle.setSucceeded(result, report.message);
    } else {
      handle.setAborted(result, report.message);
    }
  }

  Walker& walker_;
  const Words words_;
  Server server_;
};

}  // namespace hexapod
