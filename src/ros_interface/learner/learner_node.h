#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <memory>
#include <string>

#include "ros_interface/learner/learner_core.h"
#include "ros_interface/learner/repertoire_publisher.h"

namespace hexapod {

/// A LearnerCore on ROS: repertoire and markers, ~progress, ~history, ~save and ~pause.
class LearnerNode : private LearnerAudience {
 public:
  /// Throws as LearningSession does, and for a robot description that is missing or wrong.
  LearnerNode(ros::NodeHandle& node, ros::NodeHandle& private_node, const LearnerOptions& options);

  /// LearnerCore::run(), until done or the process is asked to leave.
  int run();

  std::string lastWords() const { return core_.lastWords(); }

 private:
  void show(const Repertoire& repertoire) override;
  void tell(const hexapod_repertoire::LearningProgress& progress) override;
  void tell(const hexapod_repertoire::LearningHistory& history) override;
  bool onSave(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool onPause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);

  SystemClock clock_;
  std::unique_ptr<TrialRobot> robot_;  // none unless entries are tried on that of the session
  LearnerCore core_;
  RepertoirePublisher repertoire_publisher_;
  ros::Publisher progress_publisher_;
  ros::Publisher history_publisher_;
  ros::ServiceServer save_;
  ros::ServiceServer pause_;
};

}  // namespace hexapod
