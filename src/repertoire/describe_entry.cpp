#include "repertoire/describe_entry.h"

#include <cmath>

#include "common/text.h"
#include "geometry/arc.h"
#include "geometry/pose2.h"

namespace hexapod {
namespace {

std::string inDegrees(double angle_rad, int decimals) {
  return fixedText(angle_rad / kDegree, decimals) + " deg";
}

std::string inWords(const Pose2& pose) {
  return "(" + fixedText(pose.x_m, 3) + " m, " + fixedText(pose.y_m, 3) + " m, " +
         inDegrees(pose.yaw_rad, 1) + ")";
}

}  // namespace

std::string describe(const Entry& entry) {
  const Pose2& pose = entry.expectedPose();
  std::string text = "entry " + std::to_string(entry.id) + "\nends at " + inWords(pose) +
                     "\norientation error " + inDegrees(orientationError(pose), 1);
  if (!entry.execution) return text + ", not validated";
  const Execution& execution = *entry.execution;
  text += "\nspread " + fixedText(100.0 * execution.spread_m, 1) + " cm and " +
          inDegrees(execution.spread_rad, 1) + " over " + std::to_string(execution.trials) +
          " trials";
  if (execution.falls > 0) {
    text += "\nnot used: " + std::to_string(execution.falls) + " of them failed";
  }
  return text;
}

}  // namespace hexapod
