#include "ros_interface/executor/command_sender.h"

#include <sensor_msgs/JointState.h>
#include <std_msgs/Float64.h>
#include <std_msgs/Float64MultiArray.h>
#include <trajectory_msgs/JointTrajectory.h>

#include <numeric>
#include <stdexcept>

#include "common/text.h"
#include "ros_interface/common/names.h"

namespace hexapod {
namespace {

// Only the newest command counts: after a stop no old one is to reach a consumer that is slow.
constexpr std::uint32_t kCommandQueue = 1;
// A trajectory point must lie ahead, or controllers drop it; in one period the next one comes.
constexpr double kTrajectoryHorizonPeriods = 1.5;

// The joints one controller moves.
struct Group {
  std::string topic;
  std::vector<std::size_t> joints;
};

std::vector<Group> controllerGroups(const ExecutorNodeOptions& options,
                                    const RobotDescription& robot) {
  const std::vector<std::string> names = separated(options.controllers);
  if (names.size() == 1) {
    Group all{names[0] + "/command", std::vector<std::size_t>(robot.jointCount())};
    std::iota(all.joints.begin(), all.joints.end(), 0);
    return {all};
  }
  if (names.size() != robot.legs.size()) {
    throw std::invalid_argument("~controllers names " + std::to_string(names.size()) +
                                " controllers; expected one for all joints or " +
                                std::to_string(robot.legs.size()) + ", one per leg.");
  }
  std::vector<Group> groups;
  std::size_t first = 0;
  for (std::size_t leg = 0; leg < names.size(); ++leg) {
    Group group{names[leg] + "/command", std::vector<std::size_t>(robot.legs[leg].segments.size())};
    std::iota(group.joints.begin(), group.joints.end(), first);
    first += group.joints.size();
    groups.push_back(std::move(group));
  }
  return groups;
}

class NoSender : public CommandSender {
 public:
  void send(const ros::Time&, const std::vector<double>&) override {}
};

class JointStateSender : public CommandSender {
 public:
  JointStateSender(ros::NodeHandle& node, const JointMap& map) : map_(map) {
    publishers_ = {node.advertise<sensor_msgs::JointState>(names::kJointCommand, kCommandQueue)};
    message_type_ = "sensor_msgs/JointState";
    message_.name = map.wireNames();
    message_.position.resize(message_.name.size());
  }

  void send(const ros::Time& stamp, const std::vector<double>& angles_rad) override {
    message_.header.stamp = stamp;
    map_.toWire(angles_rad, message_.position);
    publishers_[0].publish(message_);
  }

 private:
  JointMap map_;
  sensor_msgs::JointState message_;
};

class TrajectorySender : public CommandSender {
 public:
  TrajectorySender(ros::NodeHandle& node, const JointMap& map, std::vector<Group> groups,
                   double period_s)
      : map_(map), groups_(std::move(groups)), messages_(groups_.size()) {
    message_type_ = "trajectory_msgs/JointTrajectory";
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      publishers_.push_back(
          node.advertise<trajectory_msgs::JointTrajectory>(groups_[g].topic, kCommandQueue));
      for (const std::size_t j : groups_[g].joints) {
        messages_[g].joint_names.push_back(map.joints()[j].name);
      }
      messages_[g].points.resize(1);
      messages_[g].points[0].positions.resize(groups_[g].joints.size());
      messages_[g].points[0].time_from_start = ros::Duration(kTrajectoryHorizonPeriods * period_s);
    }
  }

  // Stamp 0: begin on arrival.
  void send(const ros::Time&, const std::vector<double>& angles_rad) override {
    map_.toWire(angles_rad, wire_rad_);
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      std::vector<double>& positions = messages_[g].points[0].positions;
      for (std::size_t i = 0; i < positions.size(); ++i) {
        positions[i] = wire_rad_[groups_[g].joints[i]];
      }
      publishers_[g].publish(messages_[g]);
    }
  }

 private:
  JointMap map_;
  std::vector<Group> groups_;
  std::vector<trajectory_msgs::JointTrajectory> messages_;
  std::vector<double> wire_rad_;
};

class GroupPositionSender : public CommandSender {
 public:
  GroupPositionSender(ros::NodeHandle& node, const JointMap& map, std::vector<Group> groups)
      : map_(map), groups_(std::move(groups)), messages_(groups_.size()) {
    message_type_ = "std_msgs/Float64MultiArray";
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      publishers_.push_back(
          node.advertise<std_msgs::Float64MultiArray>(groups_[g].topic, kCommandQueue));
      messages_[g].data.resize(groups_[g].joints.size());
    }
  }

  void send(const ros::Time&, const std::vector<double>& angles_rad) override {
    map_.toWire(angles_rad, wire_rad_);
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      for (std::size_t i = 0; i < groups_[g].joints.size(); ++i) {
        messages_[g].data[i] = wire_rad_[groups_[g].joints[i]];
      }
      publishers_[g].publish(messages_[g]);
    }
  }

 private:
  JointMap map_;
  std::vector<Group> groups_;
  std::vector<std_msgs::Float64MultiArray> messages_;
  std::vector<double> wire_rad_;
};

class PerJointSender : public CommandSender {
 public:
  PerJointSender(ros::NodeHandle& node, const JointMap& map, const std::string& pattern)
      : map_(map) {
    const std::string placeholder = "{joint}";
    const std::size_t at = pattern.find(placeholder);
    if (at == std::string::npos) {
      throw std::invalid_argument("~joint_topic is '" + pattern +
                                  "'; expected a topic with {joint} in it.");
    }
    message_type_ = "std_msgs/Float64";
    for (const WireJoint& joint : map.joints()) {
      std::string topic = pattern;
      topic.replace(at, placeholder.size(), joint.name);
      publishers_.push_back(node.advertise<std_msgs::Float64>(topic, kCommandQueue));
    }
  }

  void send(const ros::Time&, const std::vector<double>& angles_rad) override {
    map_.toWire(angles_rad, wire_rad_);
    for (std::size_t j = 0; j < publishers_.size(); ++j) {
      message_.data = wire_rad_[j];
      publishers_[j].publish(message_);
    }
  }

 private:
  JointMap map_;
  std_msgs::Float64 message_;
  std::vector<double> wire_rad_;
};

}  // namespace

std::unique_ptr<CommandSender> makeCommandSender(ros::NodeHandle& node,
                                                 const ExecutorNodeOptions& options,
                                                 const RobotDescription& robot,
                                                 const JointMap& map) {
  const std::string& interface = options.command_interface;
  if (interface == CommandInterface::kJointState) {
    return std::make_unique<JointStateSender>(node, map);
  }
  if (interface == CommandInterface::kJointTrajectory) {
    return std::make_unique<TrajectorySender>(node, map, controllerGroups(options, robot),
                                              options.behavior.command_period_s);
  }
  if (interface == CommandInterface::kJointGroupPosition) {
    return std::make_unique<GroupPositionSender>(node, map, controllerGroups(options, robot));
  }
  if (interface == CommandInterface::kPerJoint) {
    return std::make_unique<PerJointSender>(node, map, options.joint_topic);
  }
  return std::make_unique<NoSender>();
}

}  // namespace hexapod
