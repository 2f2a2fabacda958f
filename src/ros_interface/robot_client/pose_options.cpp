#include "ros_interface/robot_client/pose_options.h"

namespace hexapod {

std::vector<Option> declareOptions(PoseOptions& options) {
  return {
      option("global_frame", options.global_frame,
             "Frame of goals, plans and poses, without a slash."),
      option("base_frame", options.base_frame, "The robot's footprint in tf."),
      option("tf_timeout_s", options.tf_timeout_s, "s",
             "How long to wait for the transform of a goal.", 0.0, 60.0),
      option("pose_timeout_s", options.pose_timeout_s, "s",
             "A robot pose that has not changed its stamp for so long is lost.", 0.01, 60.0),
      option("pose_settle_s", options.pose_settle_s, "s",
             "The pose is read this long after the last command of a behaviour.", 0.0, 60.0),
  };
}

}  // namespace hexapod
