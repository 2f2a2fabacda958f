#include "ros_interface/planner/service_doors.h"

#include <ros/console.h>

#include <future>
#include <memory>

#include "ros_interface/common/realtime.h"

namespace hexapod {
namespace {

// Callers that wait for the end of a walk: a newer goal ends them, so there are never many, but
// those that came at once have to be heard at once, to be numbered as they came.
constexpr std::uint32_t kWalkThreads = 16;
constexpr std::uint32_t kPlanThreads = 2;

// What a caller of go_to waits for.
struct Answer {
  std::promise<WalkReport> accepted;
  std::promise<WalkReport> ended;
};

void fill(const WalkReport& report, hexapod_repertoire::GoTo::Response& response) {
  response.code = report.code;
  response.message = report.message;
  response.final_pose = report.final_pose;
  response.final_xy_error_m = static_cast<float>(report.final_xy_error_m);
  response.final_yaw_error_rad = static_cast<float>(report.final_yaw_error_rad);
  response.steps = report.steps;
  response.plan_summary = report.plan_summary;
  response.nearest_pose = report.nearest_pose;
  if (!report.plan.poses.empty()) response.plan = report.plan;
}

}  // namespace

ServiceDoors::ServiceDoors(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                           ros::CallbackQueueInterface& cancel_queue, Walker& walker)
    : walker_(walker),
      walk_spinner_(kWalkThreads, &walk_queue_),
      plan_spinner_(kPlanThreads, &plan_queue_) {
  ros::NodeHandle walks(node);
  walks.setCallbackQueue(&walk_queue_);
  go_to_ = walks.advertiseService("go_to", &ServiceDoors::goTo, this);
  ros::NodeHandle plans(node);
  plans.setCallbackQueue(&plan_queue_);
  make_plan_ = plans.advertiseService("make_plan", &ServiceDoors::makePlan, this);
  move_base_make_plan_ =
      plans.advertiseService("move_base/make_plan", &ServiceDoors::makePlan, this);
  ros::NodeHandle at_once(node);
  at_once.setCallbackQueue(&cancel_queue);
  simple_goal_ = at_once.subscribe("move_base_simple/goal", 1, &ServiceDoors::simpleGoal, this);
  ros::NodeHandle private_at_once(private_node);
  private_at_once.setCallbackQueue(&cancel_queue);
  cancel_ = private_at_once.advertiseService("cancel", &ServiceDoors::cancel, this);
  walk_spinner_.start();
  plan_spinner_.start();
}

bool ServiceDoors::goTo(hexapod_repertoire::GoTo::Request& request,
                        hexapod_repertoire::GoTo::Response& response) {
  const auto answer = std::make_shared<Answer>();
  auto accepted = answer->accepted.get_future();
  auto ended = answer->ended.get_future();
  const auto was_accepted = std::make_shared<bool>(false);
  GoalListener listener;
  listener.accepted = [answer, was_accepted](const WalkReport& report) {
    *was_accepted = true;
    answer->accepted.set_value(report);
  };
  listener.ended = [answer, was_accepted](const WalkReport& report) {
    answer->ended.set_value(report);
    if (!*was_accepted) answer->accepted.set_value(report);
  };
  GoalRequest asked;
  asked.pose = request.target_pose;
  asked.xy_tolerance_m = request.xy_tolerance_m;
  asked.yaw_tolerance_rad = request.yaw_tolerance_rad;
  response.goal_id = walker_.submit(asked, listener);
  // Both come: a goal is always answered.
  WalkReport report = accepted.get();
  response.accepted = *was_accepted;
  fill(report, response);
  if (request.wait && response.accepted) fill(ended.get(), response);
  return true;
}

bool ServiceDoors::makePlan(nav_msgs::GetPlan::Request& request,
                            nav_msgs::GetPlan::Response& response) {
  beLessUrgent(Niceness::kThinking);  // a thread for nothing else
  GoalRequest asked;
  asked.pose = request.goal;
  asked.xy_tolerance_m = request.tolerance;
  asked.plan_only = true;
  const auto stop = [this] { return walker_.isClosed(); };
  // As move_base: an empty start means where the robot stands.
  const auto examination = request.start.header.frame_id.empty()
                               ? walker_.examiner().examine(asked, stop)
                               : walker_.examiner().examineFrom(request.start, asked, stop);
  if (examination.report.success()) {
    response.plan = examination.report.plan;
  } else {
    ROS_WARN_STREAM("make_plan: " << examination.report.message);
  }
  return true;
}

bool ServiceDoors::cancel(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  response.success = walker_.cancelAll();
  response.message =
      response.success ? "Cancelled: the robot comes to rest." : "There is no goal to cancel.";
  return true;
}

void ServiceDoors::simpleGoal(const geometry_msgs::PoseStamped::ConstPtr& message) {
  GoalRequest asked;
  asked.pose = *message;
  walker_.submit(asked, {});
}

}  // namespace hexapod
