#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/spinner.h>
#include <ros/subscriber.h>
#include <std_srvs/Trigger.h>
#include <tf2/buffer_core.h>

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "ros_interface/common/clock.h"
#include "ros_interface/common/master_watch.h"
#include "ros_interface/planner/action_doors.h"
#include "ros_interface/planner/map_in_use.h"
#include "ros_interface/planner/relearner.h"
#include "ros_interface/planner/repertoire_in_use.h"
#include "ros_interface/planner/self_image.h"
#include "ros_interface/planner/service_doors.h"
#include "ros_interface/planner/simulated_paths.h"
#include "ros_interface/planner/twist_door.h"
#include "ros_interface/planner/walk_display.h"
#include "ros_interface/planner/walker.h"
#include "ros_interface/robot_client/executor_topics.h"
#include "ros_interface/robot_client/tf_pose_source.h"
#include "ros_interface/robot_client/transform_ears.h"

namespace hexapod {

/// The planner on ROS: doors for goals, tf, the repertoire, the executor's topics. Everything that
/// may wait has threads of its own; the global callback queue serves the repertoire.
class PlannerNode {
 public:
  /// Why run() came back.
  enum class End { kAskedToLeave, kMasterLost };

  /// `robot`: nothing to walk with any robot's repertoire.
  PlannerNode(ros::NodeHandle& node, ros::NodeHandle& private_node,
              const PlannerNodeOptions& options, const std::optional<RobotDescription>& robot);

  /// Serves until `leave` is set, ROS shuts down, or the master is lost. Every goal is answered
  /// when it returns, and none is taken any more.
  End run(const std::atomic<bool>& leave);

 private:
  using Repertoire = hexapod_repertoire::Repertoire;

  bool onResetBelief(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);
  void receive(const ros::MessageEvent<Repertoire const>& event);
  void receiveMap(const nav_msgs::OccupancyGrid::ConstPtr& map);
  void receiveUpdate(const map_msgs::OccupancyGridUpdate::ConstPtr& update);
  void tellOfMap(const std::string& problem);
  void answerAll(End end);
  /// Of what is wrong from outside and may come right, again and again.
  void warn();
  void lookAtBelief();
  void publishBelief(const hexapod_repertoire::BodyBelief& belief);
  void report(diagnostic_updater::DiagnosticStatusWrapper& diagnostics);

  PlannerNodeOptions options_;
  std::optional<RobotDescription> robot_;
  SystemClock clock_;
  MasterWatch master_;
  tf2::BufferCore buffer_;
  TransformEars ears_;
  TfPoseSource poses_;
  ExecutorTopics executor_;
  ros::Publisher belief_publisher_;
  ros::Publisher body_publisher_;
  std::string believed_body_;  // in the log
  SelfImage self_image_;
  SimulatedPaths paths_;
  RepertoireInUse repertoire_;
  ros::Publisher relearned_publisher_;
  Relearner relearner_;
  MapInUse map_;
  WalkDisplay display_;
  Walker walker_;
  ros::CallbackQueue goal_queue_;
  ActionDoors actions_;
  ServiceDoors services_;
  std::unique_ptr<TwistDoor> cmd_vel_;  // by option
  ros::AsyncSpinner goal_spinner_;
  ros::Subscriber repertoire_subscriber_;
  ros::ServiceServer reset_belief_service_;
  ros::CallbackQueue map_queue_;  // a large map takes a while
  ros::Subscriber map_subscriber_;
  ros::Subscriber update_subscriber_;
  ros::AsyncSpinner map_spinner_;
  std::string map_problem_;  // told last; thread of map_spinner_
  std::int64_t next_warning_ns_;
  std::string waiting_map_;  // why it waited when it was last looked at
  std::int64_t next_belief_ns_ = 0;
  diagnostic_updater::Updater updater_;
};

}  // namespace hexapod
