#include "ros_interface/planner/behavior_client.h"

#include "ros_interface/common/names.h"
#include "ros_interface/common/node_process.h"

namespace hexapod {
namespace {

constexpr double kServerTimeout = 2.0;
constexpr double kPoll = 0.05;
constexpr double kReadyTimeout = 5.0;
// A behaviour that is broken off still returns to the neutral pose.
constexpr double kCancelTimeout = 5.0;

}  // namespace

BehaviorClient::BehaviorClient(ros::NodeHandle& node) : client_(node, names::kExecute, true) {}

BehaviorClient::Result BehaviorClient::play(const Entry& entry, const std::string& run_id,
                                            double longest_s,
                                            const std::function<bool()>& cancelled) {
  if (!client_.waitForServer(ros::Duration(kServerTimeout))) {
    return {End::kFault, "No executor answers on the action execute; start the executor node.", {}};
  }
  hexapod_repertoire::ExecuteBehaviorGoal goal;
  goal.entry_id = entry.id;
  goal.genome = entry.genome;
  goal.run_id = run_id;
  // An executor that is still standing up, or returning to the neutral pose, is ready soon.
  const ros::Time patience = ros::Time::now() + ros::Duration(kReadyTimeout);
  Result result = playOnce(goal, longest_s, cancelled);
  while (result.end == End::kNotReady && ros::Time::now() < patience && !cancelled() &&
         !askedToLeave()) {
    ros::Duration(kPoll).sleep();
    result = playOnce(goal, longest_s, cancelled);
  }
  return result;
}

BehaviorClient::Result BehaviorClient::playOnce(const hexapod_repertoire::ExecuteBehaviorGoal& goal,
                                                double longest_s,
                                                const std::function<bool()>& cancelled) {
  client_.sendGoal(goal);
  ros::Time deadline = ros::Time::now() + ros::Duration(longest_s);
  bool cancelling = false;
  while (!client_.waitForResult(ros::Duration(kPoll))) {
    if (askedToLeave()) {
      client_.cancelGoal();
      return {End::kCancelled, "Shutting down.", {}};
    }
    if (!cancelling && cancelled()) {
      cancelling = true;
      client_.cancelGoal();
      deadline = ros::Time::now() + ros::Duration(kCancelTimeout);
    }
    if (ros::Time::now() > deadline) {
      client_.cancelGoal();
      return {
          End::kFault, "The executor did not finish a behaviour in time; see executor/state.", {}};
    }
  }
  const auto result = client_.getResult();
  const bool skipped =
      result && result->code == hexapod_repertoire::ExecuteBehaviorResult::SKIPPED;
  const bool played =
      skipped || client_.getState() == actionlib::SimpleClientGoalState::SUCCEEDED;
  const std::string message =
      result && !result->message.empty() ? result->message : client_.getState().getText();
  const ros::Time finished = result ? result->finished : ros::Time(0);
  if (played) return {End::kPlayed, message, finished};
  if (result && result->code == hexapod_repertoire::ExecuteBehaviorResult::NOT_READY) {
    return {End::kNotReady, message, finished};
  }
  return {cancelling ? End::kCancelled : End::kFault, message, finished};
}

}  // namespace hexapod
