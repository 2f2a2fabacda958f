#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <cstdint>
#include <memory>

#include "robot/robot_description.h"
#include "ros_interface/simulated_robot/repertoire_check.h"
#include "ros_interface/simulated_robot/robot_commands.h"
#include "ros_interface/simulated_robot/robot_publisher.h"
#include "ros_interface/simulated_robot/simulated_robot_options.h"
#include "simulation/world.h"

namespace hexapod {

/// A World that runs in real time, or as fast as asked, behind the topics of a robot.
///
/// Its time is start + n * step in integer nanoseconds, on the axis of ROS wall time; it never goes
/// back, not on reset either. After a short stall of the process the steps that were missed are
/// taken at once; when that cannot make up for it the world has stood still instead, so that what
/// it reports is never old. As fast as it can (factor 0) still waits for each command of a live
/// stream, so that none comes late. ~disturb breaks it, weakens it or changes its floor from one
/// step to the next; ~reset puts it back on its feet as it was started. Everything happens in the
/// thread of run().
class SimulatedRobotNode {
 public:
  /// Throws std::invalid_argument when options do not fit.
  SimulatedRobotNode(ros::NodeHandle& node, ros::NodeHandle& private_node,
                     const SimulatedRobotOptions& options, const RobotDescription& robot);

  /// Serves callbacks and steps until `leave` is set or ROS shuts down.
  void run(const std::atomic<bool>& leave);

 private:
  void waitAndServe(std::int64_t wait_ns);
  std::int64_t nextDeadline_ns() const;
  void awaitCommand();
  void catchUpIfStalled(std::int64_t late_ns);
  void standStill(std::int64_t late_ns);
  void step();
  void command(std::vector<double> targets_rad);
  void noteVerdict(Verdict verdict);
  void disturb(const Disturbance& disturbance);
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
  std::int64_t step_ns_;
  std::int64_t time_ns_;          // of the world's state
  std::int64_t steady_start_ns_;  // when time_ns_ of step 0 was due
  std::int64_t steps_ = 0;        // since steady_start_ns_
  bool paused_ = false;
  bool catching_up_ = false;
  Verdict verdict_ = Verdict::kWalked;
  std::uint64_t falls_ = 0;
  std::int64_t stood_still_ns_ = 0;  // altogether, because the process was too late
  RobotCommands commands_;
  RepertoireCheck repertoire_check_;
  RobotPublisher publisher_;
  ros::Publisher reset_publisher_;
  ros::ServiceServer reset_service_;
  ros::ServiceServer pause_service_;
  ros::ServiceServer disturb_service_;
  diagnostic_updater::Updater updater_;
};

}  // namespace hexapod
