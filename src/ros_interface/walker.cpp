#include "ros_interface/walker.h"

#include <ros/console.h>

#include <algorithm>

#include "hexapod_repertoire/StepReport.h"
#include "planning/path.h"
#include "ros_interface/conversions.h"

namespace hexapod {
namespace {

using Code = hexapod_repertoire::GoTo::Response;

constexpr double kPathSpacing_m = 0.02;
// Beyond its own duration: the executor's ramp to the neutral pose and the transport.
constexpr double kBehaviorGrace_s = 5.0;

std::uint8_t codeOf(PlanCode code) {
  switch (code) {
    case PlanCode::kFound:
    case PlanCode::kAlreadyThere:
      return Code::SUCCEEDED;
    case PlanCode::kInvalidGoal:
      return Code::INVALID_GOAL;
    case PlanCode::kNoRepertoire:
      return Code::NO_REPERTOIRE;
    case PlanCode::kUnreachable:
      return Code::UNREACHABLE;
    case PlanCode::kTimeout:
      return Code::PLANNING_TIMEOUT;
  }
  return Code::UNREACHABLE;
}

std::uint8_t codeOf(const Walk::Decision& decision) {
  switch (decision.state) {
    case WalkState::kArrived:
    case WalkState::kStep:
      return Code::SUCCEEDED;
    case WalkState::kStuck:
      return Code::STUCK;
    case WalkState::kPoseLost:
      return Code::POSE_LOST;
    case WalkState::kNoPlan:
      break;
  }
  return codeOf(decision.plan.code);
}

const char* const kNoRepertoireMessage =
    "No repertoire has arrived on the topic repertoire: start the learner or a repertoire_server, "
    "or wait for it.";

}  // namespace

Walker::Walker(ros::NodeHandle& node, ros::NodeHandle& private_node,
               const PlannerNodeOptions& options)
    : options_(options),
      poses_(options),
      executor_(node),
      plan_publisher_(node.advertise<nav_msgs::Path>("plan", 1, true)),
      goal_publisher_(node.advertise<geometry_msgs::PoseStamped>("current_goal", 1, true)),
      marker_publisher_(node.advertise<visualization_msgs::MarkerArray>("plan_markers", 1, true)),
      step_publisher_(private_node.advertise<hexapod_repertoire::StepReport>("step_report", 10)),
      repertoire_subscriber_(node.subscribe("repertoire", 1, &Walker::receive, this)),
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
  const PlanResult plan = planner->planner()->plan(request);
  report.code = codeOf(plan.code);
  report.message = plan.message;
  report.plan = pathOf(start, plan);
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

bool Walker::superseded() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return pending_.has_value();
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
  WalkReport report;
  const auto planner = this->planner();  // one repertoire for the whole walk
  if (!planner) {
    report.message = kNoRepertoireMessage;
    return report;
  }
  geometry_msgs::PoseStamped goal_message;
  goal_message.header.frame_id = options_.global_frame;
  goal_message.header.stamp = ros::Time::now();
  goal_message.pose = toPoseMsg(goal.pose);
  goal_publisher_.publish(goal_message);

  Walk walk(planner, goal.pose, goal.tolerance);
  ros::Time rest(0);  // when the robot came to rest after the last behaviour
  std::vector<Pose2> walked;
  std::optional<PlannedStep> played;
  while (true) {
    const PoseReading robot = poses_.robotPose(rest);
    if (!robot.pose) {
      report.code = Code::POSE_LOST;
      report.message = robot.problem;
      return report;
    }
    if (played) reportStep(goal.id, report.steps, *played, walked.back(), *robot.pose);
    walked.push_back(*robot.pose);
    report.final_pose.header.frame_id = options_.global_frame;
    report.final_pose.header.stamp = ros::Time::now();
    report.final_pose.pose = toPoseMsg(*robot.pose);
    report.final_xy_error_m = distance(*robot.pose, goal.pose);
    report.final_yaw_error_rad = headingDistance(*robot.pose, goal.pose);

    if (interrupted() || superseded()) {
      report.code = Code::PREEMPTED;
      report.message = cancel_     ? "Cancelled."
                       : shutdown_ ? "Shutting down."
                                   : "A newer goal took over.";
      return report;
    }
    const Walk::Decision decision = walk.decide(*robot.pose, [this] { return interrupted(); });
    publishPlan(goal, *robot.pose, decision.plan, walked);
    if (report.plan.poses.empty()) report.plan = pathOf(*robot.pose, decision.plan);
    if (decision.state != WalkState::kStep) {
      report.code = codeOf(decision);
      report.message = decision.message;
      return report;
    }
    if (goal.progress) {
      goal.progress(report.final_pose, report.steps,
                    report.steps + static_cast<std::uint32_t>(decision.plan.steps.size()),
                    report.final_xy_error_m);
    }
    const auto result = executor_.play(planner->repertoire().entries.at(decision.step->entry),
                                       planner->repertoire().run_id,
                                       planner->repertoire().behavior_duration_s + kBehaviorGrace_s,
                                       [this] { return interrupted(); });
    if (result.end == BehaviorClient::End::kFault || result.end == BehaviorClient::End::kNotReady) {
      report.code = Code::EXECUTOR_FAULT;
      report.message = "The executor stopped the walk: " + result.message;
      return report;
    }
    ++report.steps;
    played = decision.step;
    rest = result.finished.isZero() ? ros::Time(0)
                                    : result.finished + ros::Duration(options_.pose_settle_s);
  }
}

nav_msgs::Path Walker::pathOf(const Pose2& from, const PlanResult& plan) const {
  std::vector<Pose2> stops;
  for (const PlannedStep& step : plan.steps) stops.push_back(step.world_from_end);
  return toPathMsg(samplePath(from, stops, kPathSpacing_m), options_.global_frame,
                   ros::Time::now());
}

void Walker::publishPlan(const WalkGoal& goal, const Pose2& from, const PlanResult& plan,
                         const std::vector<Pose2>& walked) {
  PlanPicture picture;
  picture.frame = options_.global_frame;
  for (const PlannedStep& step : plan.steps) picture.stops.push_back(step.world_from_end);
  picture.path = samplePath(from, picture.stops, kPathSpacing_m);
  picture.walked = walked;
  picture.goal = goal.pose;
  picture.xy_tolerance_m = goal.tolerance.xy_m;
  plan_publisher_.publish(toPathMsg(picture.path, picture.frame, ros::Time::now()));
  marker_publisher_.publish(planMarkers(picture));
}

void Walker::reportStep(const std::string& goal_id, std::uint32_t number, const PlannedStep& step,
                        const Pose2& before, const Pose2& after) {
  hexapod_repertoire::StepReport report;
  report.header.frame_id = options_.global_frame;
  report.header.stamp = ros::Time::now();
  report.goal_id = goal_id;
  report.step = number;
  report.entry_id = step.id;
  report.start = toPose2DMsg(before);
  report.predicted = toPose2DMsg(step.world_from_end);
  report.measured = toPose2DMsg(after);
  report.xy_error_m = distance(step.world_from_end, after);
  report.yaw_error_rad = headingDistance(step.world_from_end, after);
  step_publisher_.publish(report);
}

}  // namespace hexapod
