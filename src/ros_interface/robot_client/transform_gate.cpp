#include "ros_interface/robot_client/transform_gate.h"

#include <limits>

namespace hexapod {
namespace {

// With room for tf2's history and for waits to be added.
constexpr std::uint32_t kLastSecond = std::numeric_limits<std::int32_t>::max();

}  // namespace

std::string TransformGate::whyRefused(const geometry_msgs::TransformStamped& transform,
                                      const Source& source) {
  const std::string& frame = transform.child_frame_id;
  if (frame.size() > kLongestName || transform.header.frame_id.size() > kLongestName) {
    return "A transform of " + source.node + " names a frame with more than " +
           std::to_string(kLongestName) + " characters.";
  }
  const std::string what = "The transform of frame '" + frame + "' by " + source.node;
  if (transform.header.stamp.sec > kLastSecond) {
    return what + " is stamped " + std::to_string(transform.header.stamp.sec) + " s.";
  }
  const auto known = movers_.find(frame);
  if (known == movers_.end()) {
    if (movers_.size() >= kMostFrames) {
      return what + " is one too many: there are " + std::to_string(kMostFrames) + " frames.";
    }
    movers_.emplace(frame, source);
    return "";
  }
  Source& mover = known->second;
  const bool is_other = mover.node != source.node || mover.is_static != source.is_static;
  const bool is_silent = source.arrival_ns - mover.arrival_ns > kPatience_ns;
  const bool stays_moving = !mover.is_static && source.is_static;
  if (is_other && !mover.is_static && (stays_moving || !is_silent)) {
    return what + " is left out: " + mover.node + " moves that frame; stop one of them.";
  }
  mover = source;
  return "";
}

}  // namespace hexapod
