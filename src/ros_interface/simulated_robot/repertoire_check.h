#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include <string>

#include "hexapod_repertoire/Repertoire.h"

namespace hexapod {

/// Says so as an ERROR when the repertoire that is published was learned for another robot than the
/// one that is simulated: planner and executor may have been given other files.
class RepertoireCheck {
 public:
  /// `robot_id`: digest of the robot description.
  RepertoireCheck(ros::NodeHandle& node, std::string robot_id);

 private:
  void receive(const hexapod_repertoire::Repertoire::ConstPtr& message) const;

  std::string robot_id_;
  ros::Subscriber subscriber_;
};

}  // namespace hexapod
