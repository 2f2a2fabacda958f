#include "gait/outcome.h"

#include <cmath>

#include "geometry/arc.h"

namespace hexapod {
namespace {

// 1e-5 m or rad; half away from zero, so mirrored values stay mirrored. Never -0.
double rounded(double value) { return std::round(value * 1e5) / 1e5 + 0.0; }

}  // namespace

std::string toString(Verdict verdict) {
  switch (verdict) {
    case Verdict::kWalked:
      return "walked";
    case Verdict::kFell:
      return "fell";
    case Verdict::kSelfCollided:
      return "self-collided";
    case Verdict::kDiverged:
      break;
  }
  return "diverged";
}

Outcome walkedTo(const Pose2& start_from_end) {
  Outcome outcome;
  if (!isFinite(start_from_end)) return outcome;
  const Pose2 pose{rounded(start_from_end.x_m), rounded(start_from_end.y_m),
                   rounded(wrapAngle(start_from_end.yaw_rad))};
  if (!isFinite(pose)) return outcome;
  outcome.verdict = Verdict::kWalked;
  outcome.end_pose = pose;
  outcome.cost = rounded(orientationError(pose));
  return outcome;
}

}  // namespace hexapod
