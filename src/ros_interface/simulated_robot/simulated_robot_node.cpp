#include "ros_interface/simulated_robot/simulated_robot_node.h"

#include <ros/callback_queue.h>
#include <ros/console.h>
#include <ros/init.h>
#include <std_msgs/Header.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "ros_interface/common/names.h"
#include "ros_interface/common/realtime.h"
#include "ros_interface/simulated_robot/repertoire_check.h"
#include "simulation/body_text.h"

namespace hexapod {
namespace {

// Callbacks are served at least this often, so that a signal is seen.
constexpr std::int64_t kLongestWait_ns = 50 * kMillisecond_ns;
// After a stall, commands that lie in the sockets are read before the missed steps are taken.
constexpr std::int64_t kReadAfterStall_ns = 5 * kMillisecond_ns;
constexpr std::uint32_t kCommandQueueSize = 50;
constexpr double kWarningPeriod_s = 10.0;
constexpr double kIgnoredPeriod_s = 5.0;
constexpr std::int64_t kCommandPatience_ns = 500 * kMillisecond_ns;

Engine engineFor(const SimulatedRobotOptions& options, const RobotDescription& robot) {
  const EngineChoice choice = chooseEngine(options.engine, robot);
  if (!choice.remark.empty()) ROS_WARN_STREAM(choice.remark);
  return choice.engine;
}

Disturbance fromTheStart(const SimulatedRobotOptions& options, const RobotDescription& robot) {
  Disturbance disturbance = options.disturbance;
  Physics& physics = disturbance.physics;
  physics = bodyFromText(robot, options.body, physics);
  // Commands are delayed here, not by the world.
  disturbance.latency_s += physics.command_latency_s;
  physics.command_latency_s = 0.0;
  return disturbance;
}

}  // namespace

SimulatedRobotNode::SimulatedRobotNode(ros::NodeHandle& node, ros::NodeHandle& private_node,
                                       const SimulatedRobotOptions& options,
                                       const RobotDescription& robot)
    : options_(options),
      engine_(engineFor(options, robot)),
      robot_(robot),
      started_with_(fromTheStart(options, robot)),
      timer_({secondsToNs(started_with_.physics.step_s), options.real_time_factor,
              options.publish_clock},
             clock_),
      commands_(robot, secondsToNs(options.command_latency_s)),
      observer_(robot, options.frames),
      publisher_(node, options.publish_clock),
      command_subscriber_(node.subscribe(names::kJointCommand, kCommandQueueSize,
                                         &SimulatedRobotNode::onCommand, this,
                                         ros::TransportHints().tcpNoDelay())),
      repertoire_subscriber_(
          node.subscribe(names::kRepertoire, 1, &SimulatedRobotNode::onRepertoire, this)),
      reset_publisher_(node.advertise<std_msgs::Header>(names::kRobotReset, 1)),
      reset_service_(private_node.advertiseService("reset", &SimulatedRobotNode::onReset, this)),
      pause_service_(private_node.advertiseService("pause", &SimulatedRobotNode::onPause, this)),
      disturb_service_(
          private_node.advertiseService("disturb", &SimulatedRobotNode::onDisturb, this)) {
  // It is stood up with all its legs.
  Physics standing = started_with_.physics;
  standing.legs.clear();
  world_ = makeWorld(engine_, robot, standing);
  stand_ = world_->state();
  disturb(started_with_);
  updater_.setHardwareID("simulated hexapod");
  updater_.add("simulation", this, &SimulatedRobotNode::report);
}

void SimulatedRobotNode::run(const std::atomic<bool>& leave) {
  if (options_.realtime && options_.real_time_factor == 1.0) {
    askForRealtimePriority(RealtimePriority::kRobot);
    raiseTransportPriority();
  }
  updater_.force_update();  // the first one asks the master
  // However long the start took.
  timer_.begin(static_cast<std::int64_t>(ros::WallTime::now().toNSec()));
  while (!leave && ros::ok()) {
    updater_.update();
    const std::int64_t wait_ns = timer_.wait_ns();
    if (wait_ns > 0) {
      catching_up_ = false;
      waitAndServe(wait_ns);
      continue;
    }
    catchUpIfStalled(-wait_ns);
    if (options_.real_time_factor == 0.0) awaitCommand();
    step();
  }
}

void SimulatedRobotNode::waitAndServe(std::int64_t wait_ns) {
  const double wait_s = 1e-9 * static_cast<double>(std::min(wait_ns, kLongestWait_ns));
  ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(wait_s));
}

void SimulatedRobotNode::awaitCommand() {
  waitAndServe(0);
  const std::int64_t deadline_ns = steadyNow_ns() + kCommandPatience_ns;
  while (commands_.expects(timer_.time_ns()) && steadyNow_ns() < deadline_ns)
    waitAndServe(kMillisecond_ns);
  if (commands_.expects(timer_.time_ns())) commands_.giveUp();
}

void SimulatedRobotNode::catchUpIfStalled(std::int64_t late_ns) {
  if (!timer_.isStall(late_ns)) return;
  if (!catching_up_) {
    sleepUntilSteady(steadyNow_ns() + kReadAfterStall_ns);
    waitAndServe(0);
  }
  catching_up_ = true;
  const std::int64_t stood_ns = timer_.standStill(late_ns);
  stood_still_ns_ += stood_ns;
  if (stood_ns == 0) return;
  ROS_WARN_STREAM_THROTTLE(kWarningPeriod_s,
                           "The simulated robot stood still for "
                               << 1e-9 * static_cast<double>(stood_ns)
                               << " s: its process was stopped, or the machine is too busy.");
}

void SimulatedRobotNode::step() {
  const std::vector<double>* targets = commands_.due(timer_.time_ns());
  if (targets != nullptr) command(*targets);
  if (!timer_.isPaused()) noteVerdict(world_->step());
  timer_.step();
  const ros::Time now = timeFromNs(timer_.time_ns());
  publisher_.publish(observer_.observe(*world_, now), now);
}

void SimulatedRobotNode::command(std::vector<double> targets_rad) {
  if (disturbance_.dead_band_rad > 0.0) {
    std::vector<double> angles_rad;
    world_->jointAngles(angles_rad);
    for (std::size_t j = 0; j < angles_rad.size(); ++j) {
      if (std::abs(targets_rad[j] - angles_rad[j]) < disturbance_.dead_band_rad) {
        targets_rad[j] = angles_rad[j];
      }
    }
  }
  world_->setTargets(targets_rad);
}

// Another body where the robot stands, as it stands, with the targets it has.
void SimulatedRobotNode::disturb(const Disturbance& disturbance) {
  const WorldState now = world_->state();
  auto world = makeWorld(engine_, robot_, disturbance.physics, &stand_);
  world->restore(now);
  world->setTargets(
      {now.values.end() - static_cast<std::ptrdiff_t>(robot_.jointCount()), now.values.end()});
  world_ = std::move(world);
  disturbance_ = disturbance;
  commands_.disturb(std::llround(disturbance.latency_s * 1e9), disturbance.dropped_share);
  observer_.disturb(robot_, disturbance);
}

bool SimulatedRobotNode::onDisturb(hexapod_repertoire::Disturb::Request& request,
                                   hexapod_repertoire::Disturb::Response& response) {
  try {
    std::vector<double> angles_rad;
    world_->jointAngles(angles_rad);
    disturb(disturbanceFrom(request, started_with_, robot_, angles_rad));
    response.success = true;
    response.message = describe(disturbance_, robot_);
  } catch (const std::invalid_argument& error) {
    response.success = false;
    response.message = error.what();
  }
  return true;
}

void SimulatedRobotNode::noteVerdict(Verdict verdict) {
  if (verdict == verdict_) return;
  verdict_ = verdict;
  if (verdict == Verdict::kWalked) return;
  ++falls_;
  ROS_WARN_STREAM("The simulated robot "
                  << toString(verdict)
                  << (verdict == Verdict::kDiverged ? "; call ~reset to put it back on its feet."
                                                    : "; it goes on."));
}

void SimulatedRobotNode::onCommand(const sensor_msgs::JointState::ConstPtr& command) {
  if (commands_.take(*command)) return;
  ROS_WARN_STREAM_THROTTLE(kIgnoredPeriod_s, "A joint command is ignored: " << commands_.problem());
}

void SimulatedRobotNode::onRepertoire(
    const hexapod_repertoire::Repertoire::ConstPtr& repertoire) const {
  const std::string problem = wrongRobot(*repertoire, robot_.digest);
  if (!problem.empty()) ROS_ERROR_STREAM(problem);
}

bool SimulatedRobotNode::onReset(std_srvs::Trigger::Request&,
                                 std_srvs::Trigger::Response& response) {
  disturb(started_with_);
  world_->restart();
  world_->setTargets(robot_.neutralPose());
  commands_.clear();
  observer_.forgetMotion();
  verdict_ = Verdict::kWalked;
  std_msgs::Header header;
  header.stamp = timeFromNs(timer_.time_ns());
  header.frame_id = options_.frames.odom_frame;
  reset_publisher_.publish(header);
  response.success = true;
  response.message = "The robot stands at the origin as it was started; its time goes on.";
  return true;
}

bool SimulatedRobotNode::onPause(std_srvs::SetBool::Request& request,
                                 std_srvs::SetBool::Response& response) {
  timer_.pause(request.data);
  response.success = true;
  response.message = timer_.isPaused() ? "The robot stands still." : "The robot moves.";
  return true;
}

void SimulatedRobotNode::report(diagnostic_updater::DiagnosticStatusWrapper& diagnostics) {
  const bool fine = verdict_ == Verdict::kWalked;
  diagnostics.summary(
      fine ? diagnostic_msgs::DiagnosticStatus::OK : diagnostic_msgs::DiagnosticStatus::WARN,
      fine ? (timer_.isPaused() ? "paused" : "running") : toString(verdict_));
  const RobotCommands::Counts& counts = commands_.counts();
  diagnostics.add("Commands received", counts.received);
  diagnostics.add("Commands ignored", counts.refused);
  diagnostics.add("Last ignored because", commands_.problem());
  diagnostics.add("Commands late", counts.late);
  diagnostics.add("Commands of another clock", counts.foreign);
  diagnostics.add("Commands out of order", counts.dropped);
  diagnostics.add("Commands lost on purpose", counts.lost);
  diagnostics.add("Disturbance", describe(disturbance_, robot_));
  diagnostics.add("Falls and other failures", falls_);
  diagnostics.add("Stood still because too late [s]", 1e-9 * static_cast<double>(stood_still_ns_));
}

}  // namespace hexapod
