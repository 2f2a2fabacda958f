#include "ros_interface/executor/executor_services.h"

namespace hexapod {

ExecutorServices::ExecutorServices(const ros::NodeHandle& private_node, SharedExecutor& executor,
                                   const JointFeedback& feedback,
                                   std::vector<std::string> joint_names)
    : executor_(executor),
      feedback_(feedback),
      joint_names_(std::move(joint_names)),
      private_node_(private_node),
      spinner_(1, &queue_) {
  private_node_.setCallbackQueue(&queue_);
  advertise("arm", &SharedExecutor::arm);
  advertise("disarm", &SharedExecutor::disarm);
  advertise("stand", &SharedExecutor::stand);
  advertise("sit", &SharedExecutor::sit);
  spinner_.start();
}

std::string ExecutorServices::explain(const Cause& cause) const {
  const std::string text = sentence(cause, joint_names_);
  const std::string rivals = feedback_.rivals();
  const bool name = cause.reason == Reason::kTwoSources && !rivals.empty();
  return name ? text + " They are " + rivals + "." : text;
}

void ExecutorServices::advertise(const std::string& name, Cause (SharedExecutor::*request)()) {
  using Service = bool(std_srvs::Trigger::Request&, Response&);
  services_.push_back(private_node_.advertiseService(
      name,
      boost::function<Service>([this, request](std_srvs::Trigger::Request&, Response& response) {
        const Cause cause = (executor_.*request)();
        response.success = cause.accepted() || cause.reason == Reason::kAlreadyArmed;
        response.message = explain(cause);
        return true;
      })));
}

}  // namespace hexapod
