#include "ros_interface/common/conversions.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "geometry/arc.h"
#include "repertoire/repertoire_file.h"
#include "repertoire/repertoire_rows.h"

namespace hexapod {
namespace {

hexapod_repertoire::RepertoireEntry toMsg(const Entry& entry) {
  hexapod_repertoire::RepertoireEntry message;
  message.id = entry.id;
  message.genome = entry.genome;
  message.end_pose = toPose2DMsg(entry.end_pose);
  message.orientation_error_rad = entry.orientationErrorRad();
  message.cost = entry.cost;
  const Arc arc = arcThrough(entry.end_pose.x_m, entry.end_pose.y_m);
  message.curvature_per_m = arc.curvature_per_m;
  message.arc_length_m = arc.length_m;
  message.evaluation = entry.evaluation;
  if (entry.execution) {
    message.trials = entry.execution->trials;
    message.falls = entry.execution->falls;
    message.executed_pose = toPose2DMsg(entry.execution->mean);
    message.spread_m = entry.execution->spread_m;
    message.spread_rad = entry.execution->spread_rad;
  }
  return message;
}

Pose2 fromMsg(const geometry_msgs::Pose2D& message) {
  return {message.x, message.y, message.theta};
}

Entry fromMsg(const hexapod_repertoire::RepertoireEntry& message) {
  Entry entry;
  entry.id = message.id;
  entry.genome = message.genome;
  entry.end_pose = fromMsg(message.end_pose);
  entry.cost = message.cost;
  entry.evaluation = message.evaluation;
  if (message.trials > 0) {
    entry.execution =
        Execution{fromMsg(message.executed_pose), message.spread_m, message.spread_rad,
                  static_cast<int>(message.trials), static_cast<int>(message.falls)};
  }
  return entry;
}

}  // namespace

hexapod_repertoire::Repertoire toMsg(const Repertoire& repertoire, const ros::Time& stamp,
                                     const std::string& base_frame) {
  hexapod_repertoire::Repertoire message;
  message.header.stamp = stamp;
  message.header.frame_id = base_frame;
  message.format_version = kFormatVersion;
  message.run_id = repertoire.run_id;
  message.robot_id = repertoire.robot_id;
  message.seed = repertoire.seed;
  message.generation = repertoire.generation;
  message.evaluations = repertoire.evaluations;
  message.behavior_duration_s = repertoire.behavior_duration_s;
  message.joint_names = repertoire.joint_names;
  for (const auto& [name, value] : repertoire.options) {
    message.option_names.push_back(name);
    message.option_values.push_back(value);
  }
  message.entries.reserve(repertoire.entries.size());
  for (const Entry& entry : repertoire.entries) message.entries.push_back(toMsg(entry));
  return message;
}

std::string optionOf(const hexapod_repertoire::Repertoire& message, const std::string& name) {
  const std::size_t count = std::min(message.option_names.size(), message.option_values.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (message.option_names[i] == name) return message.option_values[i];
  }
  return "";
}

Repertoire fromMsg(const hexapod_repertoire::Repertoire& message) {
  Repertoire repertoire;
  repertoire.run_id = message.run_id;
  repertoire.robot_id = message.robot_id;
  repertoire.seed = message.seed;
  repertoire.generation = message.generation;
  repertoire.evaluations = message.evaluations;
  repertoire.behavior_duration_s = message.behavior_duration_s;
  repertoire.joint_names = message.joint_names;
  if (message.option_names.size() != message.option_values.size()) {
    throw std::invalid_argument("The repertoire message of run '" + message.run_id +
                                "' is refused: it names " +
                                std::to_string(message.option_names.size()) + " options and has " +
                                std::to_string(message.option_values.size()) + " values.");
  }
  for (std::size_t i = 0; i < message.option_names.size(); ++i) {
    repertoire.options[message.option_names[i]] = message.option_values[i];
  }
  std::set<std::int64_t> ids;
  const GenomeShape shape{message.entries.empty() ? 0 : message.entries.front().genome.size(),
                          repertoire.geneLevels()};
  for (const auto& entry_message : message.entries) {
    Entry entry = fromMsg(entry_message);
    std::string problem = problemOf(entry, shape);
    if (!ids.insert(entry.id).second) problem = "stands there twice";
    if (!problem.empty()) {
      throw std::invalid_argument("The repertoire message of run '" + message.run_id +
                                  "' is refused: entry " + std::to_string(entry.id) + " " +
                                  problem + ".");
    }
    repertoire.entries.push_back(std::move(entry));
  }
  return repertoire;
}

geometry_msgs::Pose toPoseMsg(const Pose2& pose) {
  geometry_msgs::Pose message;
  message.position.x = pose.x_m;
  message.position.y = pose.y_m;
  message.orientation.z = std::sin(pose.yaw_rad / 2.0);
  message.orientation.w = std::cos(pose.yaw_rad / 2.0);
  return message;
}

geometry_msgs::Pose2D toPose2DMsg(const Pose2& pose) {
  geometry_msgs::Pose2D message;
  message.x = pose.x_m;
  message.y = pose.y_m;
  message.theta = pose.yaw_rad;
  return message;
}

nav_msgs::Path toPathMsg(const std::vector<Pose2>& poses, const std::string& frame,
                         const ros::Time& stamp) {
  nav_msgs::Path path;
  path.header.frame_id = frame;
  path.header.stamp = stamp;
  for (const Pose2& pose : poses) {
    geometry_msgs::PoseStamped stamped;
    stamped.header = path.header;
    stamped.pose = toPoseMsg(pose);
    path.poses.push_back(stamped);
  }
  return path;
}

geometry_msgs::Quaternion toQuaternionMsg(const Eigen::Quaterniond& rotation) {
  geometry_msgs::Quaternion message;
  message.x = rotation.x();
  message.y = rotation.y();
  message.z = rotation.z();
  message.w = rotation.w();
  return message;
}

geometry_msgs::TransformStamped toTransformMsg(const Eigen::Isometry3d& parent_from_child,
                                               const std::string& parent, const std::string& child,
                                               const ros::Time& stamp) {
  geometry_msgs::TransformStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = parent;
  message.child_frame_id = child;
  message.transform.translation.x = parent_from_child.translation().x();
  message.transform.translation.y = parent_from_child.translation().y();
  message.transform.translation.z = parent_from_child.translation().z();
  message.transform.rotation =
      toQuaternionMsg(Eigen::Quaterniond(parent_from_child.linear()).normalized());
  return message;
}

std::optional<Pose2> fromPoseMsg(const geometry_msgs::Pose& message, std::string& problem) {
  const auto& p = message.position;
  const auto& q = message.orientation;
  for (const double number : {p.x, p.y, p.z, q.x, q.y, q.z, q.w}) {
    if (!std::isfinite(number)) {
      problem = "a coordinate of the pose is not a finite number";
      return std::nullopt;
    }
  }
  const double norm = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  if (std::abs(norm - 1.0) > 0.01) {
    problem = "the quaternion has length " + std::to_string(norm) +
              ", expected 1; for no rotation set orientation.w to 1";
    return std::nullopt;
  }
  const double up = 1.0 - 2.0 * (q.x * q.x + q.y * q.y) / (norm * norm);
  if (std::acos(std::min(1.0, std::max(-1.0, up))) > kMaxGoalTilt) {
    problem = "the pose is tilted out of the plane; the robot walks on the floor, set only the yaw";
    return std::nullopt;
  }
  const double yaw = std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
  return Pose2{p.x, p.y, yaw};
}

}  // namespace hexapod
