#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Pose2D.h>
#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Path.h>
#include <ros/time.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "geometry/pose2.h"
#include "hexapod_repertoire/Repertoire.h"
#include "repertoire/repertoire.h"
#include "ros_interface/common/names.h"

namespace hexapod {

/// The message of a repertoire, stamped `stamp`.
hexapod_repertoire::Repertoire toMsg(const Repertoire& repertoire, const ros::Time& stamp,
                                     const std::string& base_frame = names::kFootprintFrame);

/// An option of the run of a repertoire message; empty when it does not say.
std::string optionOf(const hexapod_repertoire::Repertoire& message, const std::string& name);

/// The repertoire of a message. Checks what arrives from a wire: throws std::invalid_argument
/// naming the entry when it could not stand in a file either (see problemOf), or an id occurs
/// twice.
Repertoire fromMsg(const hexapod_repertoire::Repertoire& message);

geometry_msgs::Pose toPoseMsg(const Pose2& pose);
geometry_msgs::Pose2D toPose2DMsg(const Pose2& pose);
nav_msgs::Path toPathMsg(const std::vector<Pose2>& poses, const std::string& frame,
                         const ros::Time& stamp);

geometry_msgs::Quaternion toQuaternionMsg(const Eigen::Quaterniond& rotation);
geometry_msgs::TransformStamped toTransformMsg(const Eigen::Isometry3d& parent_from_child,
                                               const std::string& parent, const std::string& child,
                                               const ros::Time& stamp);

/// Largest tilt of a goal out of the plane that is still read as one in the plane [rad].
constexpr double kMaxGoalTilt = 0.05;

/// The pose in the plane of a message; position.z is ignored. Empty with a sentence in `problem`
/// when a number is not finite, the quaternion is not of unit length (within 1 %) or tilts the z
/// axis by more than kMaxGoalTilt.
std::optional<Pose2> fromPoseMsg(const geometry_msgs::Pose& message, std::string& problem);

}  // namespace hexapod
