#include "ros_interface/planner/pose_source.h"

#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include <cmath>
#include <sstream>

#include "ros_interface/common/conversions.h"

namespace hexapod {
namespace {

PoseReading failure(const std::string& problem) { return {std::nullopt, problem}; }

}  // namespace

PoseSource::PoseSource(const PlannerNodeOptions& options) : options_(options), listener_(buffer_) {}

PoseReading PoseSource::robotPose(const ros::Time& after) const {
  const std::string& global = options_.global_frame;
  const std::string& base = options_.base_frame;
  try {
    if (!after.isZero()) {
      const ros::Duration until_then = std::max(ros::Duration(0), after - ros::Time::now());
      buffer_.canTransform(global, base, after,
                           until_then + ros::Duration(options_.pose_timeout_s));
    }
    const auto transform = buffer_.lookupTransform(
        global, base, ros::Time(0),
        after.isZero() ? ros::Duration(options_.pose_timeout_s) : ros::Duration(0));
    const double age_s = (ros::Time::now() - transform.header.stamp).toSec();
    if (age_s > options_.pose_timeout_s || transform.header.stamp < after) {
      std::ostringstream problem;
      problem << "The robot's pose is lost: the newest transform from " << global << " to " << base
              << " is " << age_s << " s old. Check the robot's odometry.";
      return failure(problem.str());
    }
    const auto& translation = transform.transform.translation;
    geometry_msgs::Pose pose;
    pose.position.x = translation.x;
    pose.position.y = translation.y;
    pose.orientation = transform.transform.rotation;
    const auto& q = pose.orientation;
    const double yaw =
        std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
    const Pose2 result{translation.x, translation.y, yaw};
    if (!isFinite(result))
      return failure("The robot's pose is lost: tf gives a pose that is not finite.");
    return {result, ""};
  } catch (const tf2::TransformException& error) {
    return failure("The robot's pose is lost: tf has no transform from " + global + " to " + base +
                   " (" + error.what() + "). Check that the robot publishes its odometry to tf.");
  }
}

PoseReading PoseSource::goalPose(const geometry_msgs::PoseStamped& goal) const {
  geometry_msgs::PoseStamped stamped = goal;
  std::string& frame = stamped.header.frame_id;
  if (!frame.empty() && frame.front() == '/') frame.erase(0, 1);  // tf1 wrote /odom
  if (frame.empty()) {
    return failure("The goal names no frame; set header.frame_id, e.g. to " +
                   options_.global_frame + ".");
  }
  try {
    const auto moved =
        buffer_.transform(stamped, options_.global_frame, ros::Duration(options_.tf_timeout_s));
    std::string problem;
    const auto pose = fromPoseMsg(moved.pose, problem);
    if (!pose)
      return failure("The goal, brought into " + options_.global_frame +
                     ", is refused: " + problem + ".");
    return {pose, ""};
  } catch (const tf2::TransformException& error) {
    return failure("tf cannot bring the goal from frame " + frame + " into " +
                   options_.global_frame + ": " + error.what() +
                   ". Send it in a frame of the tf tree, with stamp 0 for the latest transform.");
  }
}

}  // namespace hexapod
