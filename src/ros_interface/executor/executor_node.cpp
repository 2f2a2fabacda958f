#include "ros_interface/executor/executor_node.h"

#include <ros/callback_queue.h>
#include <ros/console.h>
#include <ros/init.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "ros_interface/common/names.h"
#include "ros_interface/common/params.h"

namespace hexapod {
namespace {

// How often a status is looked at; a sixth of a command period.
constexpr double kPoll_s = 0.005;
constexpr std::int64_t kAutoArmPeriod_ns = 200'000'000;
constexpr double kAutoArmWarnPeriod_s = 5.0;

JointMap readJointMap(const std::string& path, const RobotDescription& robot) {
  if (path.empty()) return JointMap::identity(robot.jointNames());
  std::ifstream file(expandHome(path));
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw std::invalid_argument("~joint_map: the file " + path + " cannot be read.");
  try {
    return JointMap::fromYaml(text.str(), robot.jointNames(), path);
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument(error.what());
  }
}

std::int64_t periodOf(const BehaviorOptions& options) {
  return std::llround(options.command_period_s * 1e9);
}

// On these another publisher matters.
std::vector<std::string> topicsToWatch(const ros::NodeHandle& node, const CommandSender& sender) {
  std::vector<std::string> topics{node.resolveName(names::kRepertoire)};
  for (const ros::Publisher& publisher : sender.publishers())
    topics.push_back(publisher.getTopic());
  return topics;
}

// Once in a session: roslaunch sets the parameter when it begins, not when it starts a node again.
bool takeAutoArm(const ros::NodeHandle& private_node, bool auto_arm) {
  if (auto_arm) private_node.setParam("auto_arm", false);
  return auto_arm;
}

}  // namespace

ExecutorNode::ExecutorNode(ros::NodeHandle& node, const ros::NodeHandle& private_node,
                           const ExecutorNodeOptions& options, const RobotDescription& robot)
    : robot_(robot),
      map_(readJointMap(options.joint_map, robot_)),
      auto_arm_(takeAutoArm(private_node, options.auto_arm)),
      executor_(robot_, options.behavior, options.executor),
      sender_(makeCommandSender(node, options, robot_, map_)),
      sending_(executor_, *sender_, options.realtime),
      loop_({periodOf(options.behavior), options.realtime}, clock_, loopCallbacks()),
      emergency_stop_(node, private_node, executor_, options.realtime),
      feedback_(node, executor_, map_, options.executor.feedback_timeout_s, clock_,
                options.realtime),
      belief_(node, executor_, robot_, options.executor, clock_),
      services_(private_node, executor_, feedback_, robot_.jointNames()),
      master_(topicsToWatch(node, *sender_)),
      action_(node, {executor_, loop_, feedback_, master_, robot_}, options.behavior),
      reports_(
          private_node,
          {executor_, *sender_, feedback_, belief_, services_, emergency_stop_, master_, loop_},
          robot_) {}

RealtimeLoop::Callbacks ExecutorNode::loopCallbacks() {
  RealtimeLoop::Callbacks callbacks;
  callbacks.tick = [this](std::int64_t slot, const ros::Time& stamp) {
    executor_.tick(slot, toNs(stamp));
  };
  callbacks.idle = [this] { executor_.serve(); };
  callbacks.may_move_stamps = [this] { return executor_.modeInLoop() != ExecutorMode::kWalking; };
  return callbacks;
}

ExecutorNode::End ExecutorNode::run(const std::atomic<bool>& leave) {
  loop_.start();
  End end = End::kAskedToLeave;
  while (!leave && ros::ok()) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(kPoll_s));
    if (loop_.takeTimeJump()) executor_.cancel(Reason::kTimeJumped);
    breakOffAfterReset();
    const ExecutorStatus status = executor_.status();
    action_.poll(status);
    reports_.poll(status);
    if (auto_arm_) autoArm();
    const bool moving = sendsCommands(status.mode) && status.mode != ExecutorMode::kReady;
    if (master_.masterIsLost() && !moving) {
      end = End::kMasterLost;
      break;
    }
  }
  executor_.stop(Reason::kShutDown);
  loop_.stop();
  action_.abort(sentence({Reason::kShutDown}, {}));
  return end;
}

void ExecutorNode::autoArm() {
  if (clock_.steadyNow_ns() < next_auto_arm_ns_ || loop_.waitsForClock()) return;
  next_auto_arm_ns_ = clock_.steadyNow_ns() + kAutoArmPeriod_ns;
  const Cause cause = executor_.arm();
  // Once: after a stop or a fault, a person arms.
  auto_arm_ = !cause.accepted() && executor_.status().cause.reason == Reason::kNeverArmed;
  if (!auto_arm_) return;
  ROS_WARN_STREAM_DELAYED_THROTTLE(kAutoArmWarnPeriod_s,
                                   "Not armed yet: " << services_.explain(cause));
}

void ExecutorNode::breakOffAfterReset() {
  const auto reset_ns = feedback_.takeReset();
  // A behaviour that began after the reset is not concerned.
  if (reset_ns && loop_.due_ns(executor_.status().first_slot) < *reset_ns) {
    executor_.cancel(Reason::kRobotReset);
  }
}

}  // namespace hexapod
