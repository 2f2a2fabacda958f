#include "ros_interface/executor/emergency_stop.h"

#include <ros/console.h>
#include <std_srvs/Trigger.h>

#include "ros_interface/common/realtime.h"

namespace hexapod {
namespace {

constexpr char kTopic[] = "e_stop";
constexpr char kService[] = "stop";
constexpr std::uint32_t kStopQueue = 10;
// How often the thread looks whether it is to leave.
constexpr double kStopLook_s = 0.1;

}  // namespace

EmergencyStop::EmergencyStop(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                             SharedExecutor& executor, bool realtime)
    : desk_(executor), node_(node), private_node_(private_node) {
  node_.setCallbackQueue(&queue_);
  private_node_.setCallbackQueue(&queue_);
  topic_ = node_.subscribe(kTopic, kStopQueue, &EmergencyStop::onEStop, this,
                           ros::TransportHints().tcpNoDelay());
  using Response = std_srvs::Trigger::Response;
  using Service = bool(std_srvs::Trigger::Request&, Response&);
  service_ = private_node_.advertiseService(
      kService, boost::function<Service>([this](std_srvs::Trigger::Request&, Response& response) {
        response.message = desk_.stop();
        response.success = true;
        return true;
      }));
  thread_ = std::thread([this, realtime] { run(realtime); });
}

EmergencyStop::~EmergencyStop() {
  running_ = false;
  thread_.join();
}

void EmergencyStop::run(bool realtime) {
  if (realtime) askForRealtimePriority(RealtimePriority::kLoop);
  while (running_) queue_.callAvailable(ros::WallDuration(kStopLook_s));
}

void EmergencyStop::onEStop(const std_msgs::Bool::ConstPtr& message) {
  if (!desk_.hear(message->data)) return;
  ROS_WARN_STREAM("Emergency stop through " << topic_.getTopic() << ".");
}

}  // namespace hexapod
