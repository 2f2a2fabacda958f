#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <hexapod_repertoire/Repertoire.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <sensor_msgs/JointState.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <cstdint>
#include <memory>

#include "robot/robot_description.h"
#include "ros_interface/common/clock.h"
#include "ros_interface/simulated_robot/robot_commands.h"
#include "ros_interface/simulated_robot/robot_observer.h"
#include "ros_interface/simulated_robot/robot_publisher.h"
#include "ros_interface/simulated_robot/simulated_robot_options.h"
#include "ros_interface/simulated_robot/step_timer.h"
#include "simulation/world.h"

namespace hexapod {

/// A World that runs in real time, or as fast as asked, behind the topics of a robot.
///
/// Its time (StepTimer) is on the axis of ROS wall time; it never goes back, not on reset either,
/// and what it reports is never old. As fast as it can (factor 0) still waits for each command of a
/// live stream, so that none comes late. ~disturb breaks it, weakens it or changes its floor from
/// one step to the next; ~reset puts it back on its feet as it was started. Everything happens in
/// the thread of run().
class SimulatedRobotNode {
 public:
  /// Throws std::invalid_argument when options do not fit.
  SimulatedRobotNode(ros::NodeHandle& node, ros::NodeHandle& private_node,
                     const SimulatedRobotOptions& options, const RobotDescription& robot);

  /// Serves callbacks and steps until `leave` is set or ROS shuts down.
  void run(const std::atomic<bool>& leave);

 private:
  void waitAndServe(std::int64_t wait_ns);
  void awaitCommand();
  void catchUpIfStalled(std::int64_t late_ns);
  void step();
  void command(std::vector<double> targets_rad);
  void noteVerdict(Verdict verdict);
  void disturb(const Disturbance& disturbance);
  void onCommand(const sensor_msgs::JointState::ConstPtr& command);
  void onRepertoire(const hexapod_repertoire::Repertoire::ConstPtr& repertoire) const;
  bool onReset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response);
  bool onDisturb(hexapod_repertoire::Disturb::Request& request,
                 hexapod_repertoire::Disturb::Response& response);
  bool onPause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  void report(diagnostic_updater::DiagnosticStatusWrapper& diagnostics);

  SimulatedRobotOptions options_;
  Engine engine_;
  RobotDescription robot_;
  Disturbance started_with_;
  Disturbance disturbance_;
  WorldState stand_;  // of the robot without damage
  std::unique_ptr<World> world_;
  SystemClock clock_;
  StepTimer timer_;
  bool catching_up_ = false;
  Verdict verdict_ = Verdict::kWalked;
  std::uint64_t falls_ = 0;
  std::int64_t stood_still_ns_ = 0;  // altogether, because the process was too late
  RobotCommands commands_;
  RobotObserver observer_;
  RobotPublisher publisher_;
  ros::Subscriber command_subscriber_;
  ros::Subscriber repertoire_subscriber_;
  ros::Publisher reset_publisher_;
  ros::ServiceServer reset_service_;
  ros::ServiceServer pause_service_;
  ros::ServiceServer disturb_service_;
  diagnostic_updater::Updater updater_;
};

}  // namespace hexapod
