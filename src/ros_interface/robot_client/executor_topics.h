#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>

#include <cstdint>
#include <string>
#include <vector>

#include "ros_interface/robot_client/executor_client.h"

namespace hexapod {

/// The executor's topics, with a queue and thread of their own: what the executor says is heard
/// whatever else this node does.
class ExecutorTopics : private ExecutorWire {
 public:
  ExecutorTopics(const ros::NodeHandle& node, const Clock& clock);

  ExecutorClient& client() { return client_; }

 private:
  bool isConnected() const override { return goal_publisher_.getNumSubscribers() > 0; }
  void send(const hexapod_repertoire::ExecuteBehaviorActionGoal& goal) override;
  void cancel(const actionlib_msgs::GoalID& id) override;

  struct Topic {
    std::string name;
    std::uint32_t queue_size;
  };

  template <class Message>
  void listen(const Topic& topic, void (ExecutorClient::*heard)(const Message&));

  ExecutorClient client_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::Publisher goal_publisher_;
  ros::Publisher cancel_publisher_;
  std::vector<ros::Subscriber> subscribers_;
  ros::AsyncSpinner spinner_;
};

}  // namespace hexapod
