#include "ros_interface/simulated_robot/repertoire_check.h"

#include <ros/console.h>

#include <utility>

#include "ros_interface/common/names.h"

namespace hexapod {

RepertoireCheck::RepertoireCheck(ros::NodeHandle& node, std::string robot_id)
    : robot_id_(std::move(robot_id)),
      subscriber_(node.subscribe(names::kRepertoire, 1, &RepertoireCheck::receive, this)) {}

void RepertoireCheck::receive(const hexapod_repertoire::Repertoire::ConstPtr& message) const {
  if (message->robot_id.empty() || message->robot_id == robot_id_) return;
  ROS_ERROR_STREAM("The repertoire of run '"
                   << message->run_id << "' was learned for the robot " << message->robot_id
                   << ", the simulated one is " << robot_id_
                   << "; give all nodes the same robot_description and ~robot_config.");
}

}  // namespace hexapod
