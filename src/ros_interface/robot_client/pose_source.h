#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <ros/time.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "geometry/pose2.h"

namespace hexapod {

/// A pose in the plane or a sentence that tells why there is none.
struct PoseReading {
  std::optional<Pose2> pose;
  std::string problem;         ///< empty when there is a pose
  std::int64_t silent_ns = 0;  ///< for how long no new pose came though it was listened for
};

/// Where the robot stands and where goals are, in the global frame. From any thread; waits are
/// bounded in steady time, block the caller only, and end soon after `stop` is true.
class PoseSource {
 public:
  using Stop = std::function<bool()>;

  virtual ~PoseSource() = default;

  /// As known now, without waiting; a problem when the pose has stopped coming.
  virtual PoseReading latest() const = 0;

  /// A pose that is still coming; waits for it a while, and hardly when it was silent before.
  virtual PoseReading robotPose(const Stop& stop) const = 0;

  /// Where the robot has come to rest: a pose stamped at or after `rest`, the time of the last
  /// command of a behaviour and some more for the robot to settle.
  virtual PoseReading restPose(const ros::Time& rest, const Stop& stop) const = 0;

  /// A goal brought into the global frame; a stamp of 0 means the latest transform.
  virtual PoseReading goalPose(const geometry_msgs::PoseStamped& goal, const Stop& stop) const = 0;
};

}  // namespace hexapod
