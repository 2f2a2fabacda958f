#include "ros_interface/planner/walk_display.h"

#include <geometry_msgs/PoseStamped.h>
#include <ros/console.h>
#include <visualization_msgs/MarkerArray.h>

#include <cmath>
#include <utility>

#include "common/text.h"
#include "geometry/pose2.h"
#include "hexapod_repertoire/StepReport.h"
#include "hexapod_repertoire/WalkSummary.h"
#include "planning/path.h"
#include "ros_interface/common/conversions.h"

namespace hexapod {
namespace {

constexpr double kPathSpacing_m = 0.02;

std::vector<Pose2> stopsOf(const PlanResult& plan) {
  std::vector<Pose2> stops;
  for (const PlannedStep& step : plan.steps) stops.push_back(step.world_from_end);
  return stops;
}

bool looksForPoses(PlanCode code) {
  return code != PlanCode::kInvalidGoal && code != PlanCode::kNoRepertoire &&
         code != PlanCode::kStartOccupied;
}

/// "1 time", "2 times".
std::string counted(std::uint32_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// A walk in one line.
std::string describe(const WalkReport& report) {
  const WalkTally& tally = report.tally;
  std::string line = counted(report.steps, "behaviour") + " in " + fixedText(tally.duration_s, 1) +
                     " s, " + fixedText(tally.distance_m, 2) + " m";
  if (tally.measured > 0) {
    line += ", " + fixedText(100.0 * tally.xy_error_m, 1) + " cm and " +
            fixedText(tally.yaw_error_rad / kDegree, 1) +
            " deg from what was predicted in the mean, planned otherwise " +
            counted(tally.replans, "time");
  }
  if (std::isfinite(tally.clearance_m)) {
    line += ", at least " + fixedText(tally.clearance_m, 2) + " m beyond the margin to obstacles";
  }
  return line + ".";
}

}  // namespace

nav_msgs::Path pathOf(const Pose2& start, const PlanResult& plan, const std::string& frame,
                      const ros::Time& stamp) {
  return toPathMsg(samplePath(start, stopsOf(plan), kPathSpacing_m), frame, stamp);
}

void fillIn(const Pose2& start, const PlanResult& plan, const std::string& frame,
            const ros::Time& stamp, WalkReport& report) {
  report.plan = pathOf(start, plan, frame, stamp);
  report.plan_summary.steps = static_cast<std::uint32_t>(plan.steps.size());
  report.plan_summary.at_least_steps = static_cast<std::uint32_t>(plan.at_least_steps);
  report.plan_summary.length_m = plan.length_m;
  report.plan_summary.duration_s = plan.duration_s;
  report.plan_summary.clearance_m = plan.clearance_m;
  if (!looksForPoses(plan.code)) return;
  report.nearest_pose.header.frame_id = frame;
  report.nearest_pose.header.stamp = stamp;
  report.nearest_pose.pose = toPoseMsg(plan.world_from_end);
}

WalkDisplay::WalkDisplay(ros::NodeHandle& node, ros::NodeHandle& private_node, const Clock& clock,
                         Sources sources)
    : clock_(clock),
      frame_(std::move(sources.frame)),
      belief_(std::move(sources.belief)),
      plan_publisher_(node.advertise<nav_msgs::Path>("plan", 1, true)),
      goal_publisher_(node.advertise<geometry_msgs::PoseStamped>("current_goal", 1, true)),
      marker_publisher_(node.advertise<visualization_msgs::MarkerArray>("plan_markers", 1, true)),
      step_publisher_(private_node.advertise<hexapod_repertoire::StepReport>("step_report", 10)),
      summary_publisher_(
          private_node.advertise<hexapod_repertoire::WalkSummary>("walk_summary", 10)) {
  if (sources.footprint.discs.empty()) return;
  plan_.markers = {footprintMarker(sources.footprint, sources.base_frame)};
  footprint_ = plan_;
  marker_publisher_.publish(plan_);
}

void WalkDisplay::showGoal(const Pose2& goal) {
  geometry_msgs::PoseStamped message;
  message.header.frame_id = frame_;
  message.header.stamp = clock_.rosNow();
  message.pose = toPoseMsg(goal);
  goal_publisher_.publish(message);
}

void WalkDisplay::showPlan(const Pose2& start, const PlanResult& plan,
                           const std::vector<WalkedStop>& walked, const Pose2& goal,
                           double xy_tolerance_m) {
  PlanPicture picture;
  picture.frame = frame_;
  picture.stops = stopsOf(plan);
  picture.path = samplePath(start, picture.stops, kPathSpacing_m);
  for (const WalkedStop& stop : walked) {
    picture.walked.push_back(stop.measured);
    if (stop.predicted) picture.misses.push_back({*stop.predicted, stop.measured});
  }
  picture.goal = goal;
  picture.xy_tolerance_m = xy_tolerance_m;
  plan_publisher_.publish(toPathMsg(picture.path, frame_, clock_.rosNow()));
  const std::lock_guard<std::mutex> lock(mutex_);
  plan_ = planMarkers(picture);
  plan_.markers.insert(plan_.markers.end(), footprint_.markers.begin(), footprint_.markers.end());
  marker_publisher_.publish(plan_);
}

void WalkDisplay::showRefused(const Pose2& goal, double xy_tolerance_m, const WalkReport& report) {
  RefusedGoal refused{frame_, goal, xy_tolerance_m, report.message, std::nullopt};
  std::string problem;
  if (!report.nearest_pose.header.frame_id.empty()) {
    refused.nearest = fromPoseMsg(report.nearest_pose.pose, problem);
  }
  visualization_msgs::MarkerArray array = refusedMarkers(refused);
  const std::lock_guard<std::mutex> lock(mutex_);
  array.markers.insert(array.markers.begin(), plan_.markers.begin(), plan_.markers.end());
  marker_publisher_.publish(array);
}

void WalkDisplay::reportStep(const std::string& goal_id, std::uint32_t number,
                             const PlannedStep& step, const Pose2& before, const Pose2& after) {
  hexapod_repertoire::StepReport report;
  report.header.frame_id = frame_;
  report.header.stamp = clock_.rosNow();
  report.goal_id = goal_id;
  report.step = number;
  report.entry_id = step.id;
  report.start = toPose2DMsg(before);
  report.predicted = toPose2DMsg(step.world_from_end);
  report.measured = toPose2DMsg(after);
  if (belief_) report.belief = belief_();
  report.xy_error_m = distance(step.world_from_end, after);
  report.yaw_error_rad = headingDistance(step.world_from_end, after);
  step_publisher_.publish(report);
}

void WalkDisplay::reportWalk(const std::string& goal_id, const WalkReport& report) {
  const WalkTally& tally = report.tally;
  hexapod_repertoire::WalkSummary summary;
  summary.header.frame_id = frame_;
  summary.header.stamp = clock_.rosNow();
  summary.goal_id = goal_id;
  summary.code = report.code;
  summary.message = report.message;
  summary.steps = report.steps;
  summary.replans = tally.replans;
  summary.duration_s = tally.duration_s;
  summary.distance_m = tally.distance_m;
  summary.xy_error_m = tally.xy_error_m;
  summary.yaw_error_rad = tally.yaw_error_rad;
  summary.clearance_m = tally.clearance_m;
  summary_publisher_.publish(summary);
  ROS_INFO_STREAM(goal_id << ": " << describe(report));
}

void WalkDisplay::tellStanding(const std::string& why) { ROS_WARN_STREAM(why); }

}  // namespace hexapod
