#pragma once

#include <tf2/buffer_core.h>

#include <cstdint>
#include <mutex>
#include <string>

#include "ros_interface/common/clock.h"
#include "ros_interface/robot_client/pose_options.h"
#include "ros_interface/robot_client/pose_source.h"
#include "ros_interface/robot_client/silence.h"

namespace hexapod {

/// Poses from tf. Never hands out one that tf did not give.
///
/// A pose is fresh while its stamp changes, as seen on steady time: whether the stamps are near our
/// own time does not matter, so that neither a clock that is set, here or on the robot, nor
/// simulated time that jumps makes a good pose a lost one or a lost one a good one. Nor does a
/// moment in which this process did not run (Silence). A buffer whose pose has stopped coming is
/// emptied: tf refuses what is older than what it has.
class TfPoseSource : public PoseSource {
 public:
  /// Both must outlive it. Whoever owns it asks for latest() some times a second, so that the pose
  /// is watched: nobody else knows how old a stamp is.
  TfPoseSource(const PoseOptions& options, const Clock& clock, tf2::BufferCore& buffer);

  PoseReading latest() const override;
  PoseReading robotPose(const Stop& stop) const override;
  PoseReading restPose(const ros::Time& rest, const Stop& stop) const override;
  PoseReading goalPose(const geometry_msgs::PoseStamped& goal, const Stop& stop) const override;

 private:
  struct Seen {
    std::optional<Pose2> pose;  ///< the newest that ever came
    ros::Time stamp;
    std::int64_t changed_ns = 0;  ///< when the stamp was first seen, steady time
    bool changes = false;         ///< it was seen to change from the one before
    bool emptied = false;         ///< the buffer was, since
    std::string problem;          ///< why there is no newer one
    std::int64_t silent_ns = 0;   ///< for how long it was listened for in vain
  };

  /// One look at the buffer.
  Seen look() const;
  bool isFresh(const Seen& seen) const;
  PoseReading readingOf(const Seen& seen) const;
  /// Looks until `done`, or until it has listened for `patience_ns`: what it saw last.
  Seen listen(std::int64_t patience_ns, const std::function<bool(const Seen&)>& done) const;
  std::int64_t timeout_ns() const { return secondsToNs(options_.pose_timeout_s); }

  PoseOptions options_;
  const Clock& clock_;
  tf2::BufferCore& buffer_;
  mutable std::mutex mutex_;
  mutable Seen seen_;                   // guarded by mutex_
  mutable Silence silence_;             // guarded by mutex_; of new poses
  mutable std::int64_t looked_ns_ = 0;  // guarded by mutex_; steady
};

}  // namespace hexapod
