#pragma once

#include <ros/node_handle.h>
#include <sensor_msgs/JointState.h>

#include <cstdint>
#include <string>
#include <vector>

#include "execution/joint_map.h"
#include "execution/joint_matcher.h"
#include "execution/shared_executor.h"

namespace hexapod {

/// Takes joint_states, checks them and hands the robot's angles to the executor. Messages that lack
/// a joint, name one twice or hold a number that is none are counted and left out.
class JointFeedback {
 public:
  /// `executor` must outlive it.
  JointFeedback(ros::NodeHandle& node, SharedExecutor& executor, const JointMap& map);

  std::uint64_t received() const { return received_; }
  std::uint64_t refused() const { return refused_; }
  /// Sentence about the last message refused; empty when none was.
  const std::string& problem() const { return problem_; }
  std::string topic() const { return subscriber_.getTopic(); }

 private:
  void onJointState(const sensor_msgs::JointState::ConstPtr& message);

  SharedExecutor& executor_;
  JointMap map_;
  JointMatcher matcher_;
  std::vector<double> angles_rad_;
  std::uint64_t received_ = 0;
  std::uint64_t refused_ = 0;
  std::string problem_;
  ros::Subscriber subscriber_;
};

}  // namespace hexapod
