#include "ros_interface/robot_client/executor_topics.h"

#include <ros/this_node.h>

#include <string>

#include "ros_interface/common/names.h"
#include "ros_interface/common/steady_action_server.h"

namespace hexapod {
namespace {

// States and results must not be missed, however late this node is served.
constexpr std::uint32_t kQueueSize = 50;

}  // namespace

ExecutorTopics::ExecutorTopics(const ros::NodeHandle& node, const Clock& clock)
    : client_(clock, *this, ros::this_node::getName()), node_(node), spinner_(1, &queue_) {
  node_.setCallbackQueue(&queue_);
  const std::string action = names::kExecute;
  listen<hexapod_repertoire::ExecutorState>({names::kExecutorState, kQueueSize},
                                            &ExecutorClient::onState);
  listen<actionlib_msgs::GoalStatusArray>({action + "/status", kQueueSize},
                                          &ExecutorClient::onStatus);
  listen<hexapod_repertoire::ExecuteBehaviorActionFeedback>({action + "/feedback", kQueueSize},
                                                            &ExecutorClient::onFeedback);
  // The answers to other clients' bursts come with those to this one.
  listen<hexapod_repertoire::ExecuteBehaviorActionResult>({action + "/result", kActionQueueSize},
                                                          &ExecutorClient::onResult);
  goal_publisher_ =
      node_.advertise<hexapod_repertoire::ExecuteBehaviorActionGoal>(action + "/goal", kQueueSize);
  cancel_publisher_ = node_.advertise<actionlib_msgs::GoalID>(action + "/cancel", kQueueSize);
  spinner_.start();
}

template <class Message>
void ExecutorTopics::listen(const Topic& topic, void (ExecutorClient::*heard)(const Message&)) {
  const boost::function<void(const boost::shared_ptr<const Message>&)> call =
      [this, heard](const boost::shared_ptr<const Message>& message) {
        (client_.*heard)(*message);
      };
  subscribers_.push_back(node_.subscribe<Message>(
      topic.name, topic.queue_size, call, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay()));
}

void ExecutorTopics::send(const hexapod_repertoire::ExecuteBehaviorActionGoal& goal) {
  goal_publisher_.publish(goal);
}

void ExecutorTopics::cancel(const actionlib_msgs::GoalID& id) {
  // Stamp 0: this goal alone, whatever was set to the clocks.
  actionlib_msgs::GoalID message;
  message.id = id.id;
  cancel_publisher_.publish(message);
}

}  // namespace hexapod
