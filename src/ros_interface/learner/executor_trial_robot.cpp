#include "ros_interface/learner/executor_trial_robot.h"

#include <utility>

#include "ros_interface/robot_client/measured_behavior.h"

namespace hexapod {
namespace {

constexpr double kHistory_s = 10.0;
constexpr double kWatch_s = 0.1;
constexpr std::int64_t kFirstState_ns = 2 * kSecond_ns;
constexpr int kTries = 3;  // of a behaviour of which the executor skipped commands

}  // namespace

ExecutorTrialRobot::ExecutorTrialRobot(ros::NodeHandle& node, const PoseOptions& options,
                                       const Clock& clock, std::function<bool()> leaves)
    : options_(options),
      clock_(clock),
      leaves_(std::move(leaves)),
      executor_(node, clock),
      buffer_(ros::Duration(kHistory_s)),
      ears_(clock, buffer_),
      poses_(options_, clock, buffer_),
      watch_(node.createWallTimer(ros::WallDuration(kWatch_s), [this](const ros::WallTimerEvent&) {
        poses_.latest();
        executor_.client().whyNotReady();
      })) {}

void ExecutorTrialRobot::awaitState() {
  if (awaited_) return;
  awaited_ = true;
  clock_.waitUntil(clock_.steadyNow_ns() + kFirstState_ns,
                   [this] { return executor_.client().whyNotReady().empty() || leaves_(); });
}

TrialRobot::Result ExecutorTrialRobot::play(const Genome& genome) {
  awaitState();
  ExecutorClient& executor = executor_.client();
  const std::uint64_t stops = executor.stops();
  std::string problem = executor.whyNotReady();
  if (!problem.empty()) return {false, std::nullopt, problem};
  Entry entry;
  entry.genome = genome;
  MeasuredBehavior measured;
  for (int i = 0; i < kTries && (i == 0 || measured.skipped > 0); ++i) {
    measured = playMeasured({executor, poses_, ros::Duration(options_.pose_settle_s)},
                            {entry, "", stops, leaves_});
  }
  if (!measured.problem.empty()) return {false, std::nullopt, measured.problem};
  return {true, inverse(*measured.start) * *measured.reached, ""};
}

}  // namespace hexapod
