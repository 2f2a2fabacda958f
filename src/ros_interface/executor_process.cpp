#include "ros_interface/executor_process.h"

#include <ros/console.h>
#include <ros/init.h>
#include <ros/master.h>

#include <csignal>
#include <stdexcept>

#include "ros_interface/robot_param.h"

namespace hexapod {
namespace {

constexpr double kMasterPoll_s = 0.1;
constexpr int kPollsPerWarning = 30;

std::atomic<bool> leave{false};

void onSignal(int) { leave = true; }

}  // namespace

bool startProcess() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, onSignal);
  for (int poll = 0; !leave; ++poll) {
    if (ros::master::check()) {
      ros::start();
      return true;
    }
    if (poll % kPollsPerWarning == 0) {
      ROS_WARN_STREAM("No ROS master answers at " << ros::master::getURI()
                                                  << "; waiting. Start roscore or roslaunch.");
    }
    ros::WallDuration(kMasterPoll_s).sleep();
  }
  return false;
}

const std::atomic<bool>& leaveFlag() { return leave; }

RobotDescription requireRobot(const ros::NodeHandle& node, const std::string& robot_config) {
  try {
    return robotFromParams(node, robot_config);
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument(error.what());
  }
}

}  // namespace hexapod
