#include "ros_interface/robot_client/measured_behavior.h"

namespace hexapod {

MeasuredBehavior playMeasured(const RobotAccess& robot, const BehaviorPlayer::Order& order,
                              const std::function<void(const MeasuredBehavior&)>& begun) {
  MeasuredBehavior measured;
  const BehaviorPlayer::Result ready = robot.executor.awaitReady(order.stops, order.interrupted);
  if (ready.end != BehaviorPlayer::End::kPlayed) {
    measured.problem = ready.message;
    return measured;
  }
  const PoseReading before = robot.poses.restPose(ready.finished + robot.settle, order.interrupted);
  measured.start = before.pose;
  measured.problem = before.problem;
  if (!measured.start) return measured;
  if (begun) begun(measured);
  const BehaviorPlayer::Result result = robot.executor.play(order);
  if (result.end != BehaviorPlayer::End::kPlayed) {
    measured.problem = result.message.empty() ? "It was broken off." : result.message;
    return measured;
  }
  const PoseReading after = robot.poses.restPose(result.finished + robot.settle, order.interrupted);
  measured.reached = after.pose;
  measured.problem = after.problem;
  measured.skipped = result.skipped;
  if (measured.skipped > 0) {
    measured.problem = std::to_string(measured.skipped) + " of its commands were skipped.";
  }
  return measured;
}

}  // namespace hexapod
