#include "ros_interface/executor/execute_action.h"

#include <ros/callback_queue.h>
#include <ros/console.h>

#include <memory>

#include "ros_interface/common/names.h"

namespace hexapod {
namespace {

using Result = hexapod_repertoire::ExecuteBehaviorResult;
using Server = SteadyActionServer<hexapod_repertoire::ExecuteBehaviorAction>;

Result cancelledEarly() {
  Result result;
  result.code = Result::PREEMPTED;
  result.message = "Cancelled before it arrived.";
  return result;
}

/// The client of a goal of the action.
class ActionClient : public GoalSender {
 public:
  explicit ActionClient(const Server::GoalHandle& handle) : handle_(handle) {}

  void accepted() override { handle_.setAccepted(); }
  void feedback(const hexapod_repertoire::ExecuteBehaviorFeedback& feedback) override {
    handle_.publishFeedback(feedback);
  }
  void ended(const Result& result) override {
    if (result.code == Result::SUCCEEDED) {
      handle_.setSucceeded(result, result.message);
    } else if (result.code == Result::PREEMPTED) {
      handle_.setCanceled(result, result.message);
    } else {
      handle_.setAborted(result, result.message);
    }
  }
  void refused(const Result& result) override { handle_.setRejected(result, result.message); }

 private:
  Server::GoalHandle handle_;
};

BehaviorGoals::Means meansOf(const ExecuteAction::Means& means, const BehaviorOptions& options,
                             PlayableBehaviors& behaviors) {
  return {means.executor,
          behaviors,
          means.feedback.topic().empty() ? nullptr : &means.feedback.ranges(),
          [&loop = means.loop](std::int64_t slot) { return loop.stamp(slot); },
          means.robot.jointNames(),
          options.command_period_s};
}

}  // namespace

ExecuteAction::ExecuteAction(ros::NodeHandle& node, const Means& means,
                             const BehaviorOptions& options)
    : behaviors_(means.robot, options),
      publisher_([&master = means.master, topic = node.resolveName(names::kRepertoire)] {
        return master.otherPublishers(topic);
      }),
      goals_(meansOf(means, options, behaviors_)),
      server_(
          node, names::kExecute, *ros::getGlobalCallbackQueue(),
          [this](const Server::GoalHandle& handle) {
            const auto goal = handle.getGoal();  // null of an empty handle only
            if (goal) {
              goals_.take(handle.getGoalID().id, *goal, std::make_unique<ActionClient>(handle));
            }
          },
          [this](const Server::GoalHandle& handle) { goals_.cancel(handle.getGoalID().id); },
          cancelledEarly()) {
  repertoire_subscriber_ =
      node.subscribe(names::kRepertoire, 1, &ExecuteAction::onRepertoire, this);
  server_.start();
}

void ExecuteAction::onRepertoire(
    const ros::MessageEvent<hexapod_repertoire::Repertoire const>& event) {
  const auto& message = event.getConstMessage();
  std::string problem = publisher_.whyRefused(event.getPublisherName());
  if (problem.empty()) problem = behaviors_.update(*message);
  if (!problem.empty()) {
    ROS_ERROR_STREAM(problem);
    return;
  }
  publisher_.use(event.getPublisherName());
  ROS_INFO_STREAM("Playing from run '"
                  << message->run_id << "', " << behaviors_.entryCount() << " entries."
                  << (behaviors_.body().empty()
                          ? ""
                          : " Learned for this body: " + behaviors_.body() + "."));
}

}  // namespace hexapod
