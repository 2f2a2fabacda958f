#include "ros_interface/planner/walker.h"

#include <ros/console.h>

#include "ros_interface/common/conversions.h"
#include "ros_interface/common/names.h"
#include "ros_interface/planner/walk_run.h"

namespace hexapod {
namespace {

using Code = hexapod_repertoire::GoTo::Response;

const char* const kNoRepertoireMessage =
    "No repertoire has arrived on the topic repertoire: start the learner or a repertoire_server, "
    "or wait for it.";

}  // namespace

Walker::Walker(ros::NodeHandle& node, ros::NodeHandle& private_node,
               const PlannerNodeOptions& options)
    : options_(options),
      poses_(options),
      executor_(node),
      display_(node, private_node, options.global_frame),
      repertoire_subscriber_(node.subscribe(names::kRepertoire, 1, &Walker::receive, this)),
      thread_(&Walker::work, this) {}

Walker::~Walker() {
  shutdown_ = true;
  wake_.notify_all();
  thread_.join();
}

void Walker::receive(const hexapod_repertoire::Repertoire::ConstPtr& message) {
  try {
    auto fresh = std::make_shared<AdaptivePlanner>(fromMsg(*message), options_.planner);
    ROS_INFO_STREAM("Planning with " << fresh->planner()->usableEntries() << " of "
                                     << fresh->repertoire().entries.size() << " entries of run "
                                     << fresh->repertoire().run_id << ".");
    const std::lock_guard<std::mutex> lock(mutex_);
    planner_ = std::move(fresh);
  } catch (const std::exception& error) {
    ROS_ERROR_STREAM(error.what() << " The earlier repertoire, if any, stays in use.");
  }
}

std::shared_ptr<AdaptivePlanner> Walker::planner() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return planner_;
}

std::optional<std::size_t> Walker::usableEntries() const {
  const auto planner = this->planner();
  if (!planner) return std::nullopt;
  return planner->planner()->usableEntries();
}

WalkReport Walker::makePlan(const Pose2& goal, const GoalTolerance& tolerance) const {
  const PoseReading robot = poses_.robotPose();
  if (robot.pose) return makePlan(*robot.pose, goal, tolerance);
  WalkReport report;
  report.code = Code::POSE_LOST;
  report.message = robot.problem;
  return report;
}

WalkReport Walker::makePlan(const Pose2& start, const Pose2& goal,
                            const GoalTolerance& tolerance) const {
  WalkReport report;
  const auto planner = this->planner();
  if (!planner) {
    report.message = kNoRepertoireMessage;
    return report;
  }
  PlanRequest request;
  request.world_from_start = start;
  request.world_from_goal = goal;
  request.tolerance = tolerance;
  const PlanResult plan = planner->plan(request);
  report.code = codeOf(plan.code);
  report.message = plan.message;
  report.plan = pathOf(start, plan, options_.global_frame);
  return report;
}

std::string Walker::submit(WalkGoal goal) {
  std::optional<WalkGoal> replaced;
  std::string id;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (goal.id.empty()) goal.id = "goal_" + std::to_string(++goals_);
    id = goal.id;
    replaced = std::move(pending_);
    pending_ = std::move(goal);
  }
  wake_.notify_all();
  if (replaced && replaced->finished) {
    WalkReport report;
    report.code = Code::PREEMPTED;
    report.message = "A newer goal came before this one was begun.";
    replaced->finished(report);
  }
  return id;
}

bool Walker::cancel() {
  std::optional<WalkGoal> dropped;
  bool active = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    dropped = std::move(pending_);
    pending_.reset();
    active = !active_id_.empty();
    if (active) cancel_ = true;
  }
  if (dropped && dropped->finished) {
    WalkReport report;
    report.code = Code::PREEMPTED;
    report.message = "Cancelled before it was begun.";
    dropped->finished(report);
  }
  return active || dropped;
}

bool Walker::cancel(const std::string& goal_id) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const bool is_pending = pending_ && pending_->id == goal_id;
    if (active_id_ == goal_id) {
      cancel_ = true;
      return true;
    }
    if (!is_pending) return false;
  }
  return cancel();
}

void Walker::work() {
  while (true) {
    std::optional<WalkGoal> goal;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      wake_.wait(lock, [this] { return pending_ || shutdown_; });
      if (shutdown_) break;
      goal = std::move(pending_);
      pending_.reset();
      active_id_ = goal->id;
      cancel_ = false;
    }
    walk(*goal);
    const std::lock_guard<std::mutex> lock(mutex_);
    active_id_.clear();
  }
  cancel();
}

void Walker::walk(const WalkGoal& goal) {
  WalkReport report;
  try {
    report = walkTo(goal);
  } catch (const std::exception& error) {
    report.code = Code::EXECUTOR_FAULT;
    report.message = std::string("Internal error: ") + error.what();
  }
  if (report.code == Code::SUCCEEDED) {
    ROS_INFO_STREAM(goal.id << ": " << report.message);
  } else {
    ROS_WARN_STREAM(goal.id << ": " << report.message);
  }
  if (goal.finished) goal.finished(report);
}

WalkReport Walker::walkTo(const WalkGoal& goal) {
  const auto planner = this->planner();  // one repertoire for the whole walk
  if (!planner) {
    WalkReport report;
    report.message = kNoRepertoireMessage;
    return report;
  }
  const WalkRun::Means means{options_,
                             poses_,
                             executor_,
                             display_,
                             [this] { return interrupted(); },
                             [this] { return reasonToEnd(); }};
  return WalkRun(means, goal, planner).run();
}

std::string Walker::reasonToEnd() const {
  if (cancel_) return "Cancelled.";
  if (shutdown_) return "Shutting down.";
  const std::lock_guard<std::mutex> lock(mutex_);
  return pending_ ? "A newer goal took over." : "";
}

}  // namespace hexapod
