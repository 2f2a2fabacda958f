#include "ros_interface/executor/executor_services.h"

#include <ros/console.h>

namespace hexapod {
namespace {

constexpr char kEStopTopic[] = "e_stop";
constexpr std::uint32_t kEStopQueue = 10;
// A request waits for the command loop; a stop must not wait for a request.
constexpr std::uint32_t kThreads = 2;

}  // namespace

ExecutorServices::ExecutorServices(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                                   SharedExecutor& executor, std::vector<std::string> joint_names)
    : executor_(executor),
      joint_names_(std::move(joint_names)),
      node_(node),
      private_node_(private_node),
      spinner_(kThreads, &queue_) {
  node_.setCallbackQueue(&queue_);
  private_node_.setCallbackQueue(&queue_);
  e_stop_ = node_.subscribe(kEStopTopic, kEStopQueue, &ExecutorServices::onEStop, this,
                            ros::TransportHints().tcpNoDelay());
  advertise("arm", &SharedExecutor::arm);
  advertise("disarm", &SharedExecutor::disarm);
  advertise("stand", &SharedExecutor::stand);
  advertise("sit", &SharedExecutor::sit);
  using Service = bool(std_srvs::Trigger::Request&, Response&);
  services_.push_back(private_node_.advertiseService(
      "stop", boost::function<Service>([this](std_srvs::Trigger::Request&, Response& response) {
        executor_.stop(Reason::kStopRequested);
        response.success = true;
        response.message = "Stopped; nothing is sent until ~arm.";
        return true;
      })));
  spinner_.start();
}

void ExecutorServices::advertise(const std::string& name, Cause (SharedExecutor::*request)()) {
  using Service = bool(std_srvs::Trigger::Request&, Response&);
  services_.push_back(private_node_.advertiseService(
      name,
      boost::function<Service>([this, request](std_srvs::Trigger::Request&, Response& response) {
        const Cause cause = (executor_.*request)();
        response.success = cause.accepted() || cause.reason == Reason::kAlreadyArmed;
        response.message = sentence(cause, joint_names_);
        return true;
      })));
}

void ExecutorServices::onEStop(const std_msgs::Bool::ConstPtr& message) {
  executor_.setEStop(message->data);
  if (message->data) ROS_WARN_STREAM("Emergency stop through " << e_stop_.getTopic() << ".");
}

}  // namespace hexapod
