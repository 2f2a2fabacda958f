#include "ros_interface/robot_client/tf_pose_source.h"

#include <tf2/exceptions.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include <cmath>
#include <sstream>

#include "ros_interface/common/conversions.h"

namespace hexapod {
namespace {

// Poses of another time axis than the executor's stamps (a clock was set) are at rest this long
// after the first one, beyond the time to settle.
constexpr double kOtherAxis_s = 0.5;
constexpr std::int64_t kPosePoll_ns = 5 * kMillisecond_ns;

PoseReading failure(const std::string& problem) { return {std::nullopt, problem}; }

Pose2 planarPose(const geometry_msgs::Transform& transform) {
  const auto& q = transform.rotation;
  return {transform.translation.x, transform.translation.y,
          std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z))};
}

}  // namespace

TfPoseSource::TfPoseSource(const PoseOptions& options, const Clock& clock, tf2::BufferCore& buffer)
    : options_(options), clock_(clock), buffer_(buffer), silence_(clock) {}

TfPoseSource::Seen TfPoseSource::look() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::int64_t now_ns = clock_.steadyNow_ns();
  const bool watched = now_ns - looked_ns_ <= timeout_ns() / 2;
  looked_ns_ = now_ns;
  try {
    const auto transform =
        buffer_.lookupTransform(options_.global_frame, options_.base_frame, ros::Time(0));
    if (!seen_.pose || transform.header.stamp != seen_.stamp) {
      const bool changes = seen_.pose && watched;
      seen_ = {
          planarPose(transform.transform), transform.header.stamp, now_ns, changes, false, "", 0};
      silence_.end();
    }
  } catch (const tf2::TransformException& error) {
    seen_.problem = error.what();
  }
  seen_.silent_ns = silence_.look_ns();
  if (seen_.pose && !seen_.emptied && seen_.silent_ns > timeout_ns() / 2) {
    buffer_.clear();
    seen_.emptied = true;
  }
  return seen_;
}

bool TfPoseSource::isFresh(const Seen& seen) const {
  return seen.pose && seen.changes && clock_.steadyNow_ns() - seen.changed_ns <= timeout_ns();
}

PoseReading TfPoseSource::readingOf(const Seen& seen) const {
  if (isFresh(seen)) return {seen.pose, ""};
  std::ostringstream problem;
  problem << "The robot's pose is lost: no new transform from " << options_.global_frame << " to "
          << options_.base_frame << " has come for " << options_.pose_timeout_s << " s";
  if (!seen.problem.empty()) problem << " (" << seen.problem << ")";
  problem << ". Check that the robot publishes its odometry to tf";
  if (ros::Time::isSimTime()) problem << ", and that somebody publishes /clock";
  problem << ".";
  return {std::nullopt, problem.str(), seen.silent_ns};
}

TfPoseSource::Seen TfPoseSource::listen(std::int64_t patience_ns,
                                        const std::function<bool(const Seen&)>& done) const {
  Seen seen = look();
  Silence listened(clock_);
  while (!done(seen) && listened.look_ns() < patience_ns) {
    clock_.sleepUntil(clock_.steadyNow_ns() + kPosePoll_ns);
    seen = look();
  }
  return seen;
}

PoseReading TfPoseSource::latest() const { return readingOf(look()); }

PoseReading TfPoseSource::robotPose(const Stop& stop) const {
  // A silence that was waited for already may end just now.
  const bool was_silent = look().silent_ns > timeout_ns();
  return readingOf(listen(timeout_ns() / (was_silent ? 5 : 1),
                          [&](const Seen& seen) { return isFresh(seen) || stop(); }));
}

PoseReading TfPoseSource::restPose(const ros::Time& rest, const Stop& stop) const {
  const ros::Duration settled(options_.pose_settle_s + kOtherAxis_s);
  Seen seen = look();
  ros::Time first = seen.stamp;
  // Ends: the stamps go on, or the pose is lost.
  while (!stop() && seen.stamp < rest && seen.stamp < first + settled) {
    const ros::Time before = seen.stamp;
    seen = listen(timeout_ns() - seen.silent_ns,
                  [&](const Seen& now) { return now.stamp != before || stop(); });
    if (seen.stamp == before) break;
    if (seen.stamp < before) first = seen.stamp;
  }
  return robotPose(stop);
}

PoseReading TfPoseSource::goalPose(const geometry_msgs::PoseStamped& goal, const Stop& stop) const {
  geometry_msgs::PoseStamped stamped = goal;
  std::string& frame = stamped.header.frame_id;
  if (!frame.empty() && frame.front() == '/') frame.erase(0, 1);  // tf1 wrote /odom
  if (frame.empty()) {
    return failure("The goal names no frame; set header.frame_id, e.g. to " +
                   options_.global_frame + ".");
  }
  std::string why;
  clock_.waitUntil(clock_.steadyNow_ns() + secondsToNs(options_.tf_timeout_s), [&] {
    return stop() || buffer_.canTransform(options_.global_frame, frame, stamped.header.stamp, &why);
  });
  try {
    const auto transform =
        buffer_.lookupTransform(options_.global_frame, frame, stamped.header.stamp);
    geometry_msgs::PoseStamped moved;
    tf2::doTransform(stamped, moved, transform);
    std::string problem;
    const auto pose = fromPoseMsg(moved.pose, problem);
    if (pose) return {pose, ""};
    return failure("The goal, brought into " + options_.global_frame + ", is refused: " + problem +
                   ".");
  } catch (const tf2::TransformException& error) {
    return failure("tf cannot bring the goal from frame " + frame + " into " +
                   options_.global_frame + ": " + error.what() +
                   ". Send it in a frame of the tf tree, with stamp 0 for the latest transform.");
  }
}

}  // namespace hexapod
