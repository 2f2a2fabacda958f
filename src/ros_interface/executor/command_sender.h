#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <memory>
#include <string>
#include <vector>

#include "execution/joint_map.h"
#include "robot/robot_description.h"
#include "ros_interface/executor/executor_node_options.h"

namespace hexapod {

/// Publishes commands in one of the forms servo drivers and controllers take.
class CommandSender {
 public:
  virtual ~CommandSender() = default;

  /// Joint angles [rad] in joint order as the robot description counts them; `stamp` is the nominal
  /// time of the command. Called from the sending thread only.
  virtual void send(const ros::Time& stamp, const std::vector<double>& angles_rad) = 0;

  /// The topics it publishes on; empty for the interface none.
  const std::vector<ros::Publisher>& publishers() const { return publishers_; }
  const std::string& messageType() const { return message_type_; }

 protected:
  std::vector<ros::Publisher> publishers_;
  std::string message_type_;
};

/// The sender of options.command_interface. Throws std::invalid_argument when `controllers` names
/// neither one controller nor one per leg, or joint_topic has no {joint}.
std::unique_ptr<CommandSender> makeCommandSender(ros::NodeHandle& node,
                                                 const ExecutorNodeOptions& options,
                                                 const RobotDescription& robot,
                                                 const JointMap& map);

}  // namespace hexapod
