#include "ros_interface/planner/tally_keeper.h"

#include <algorithm>

namespace hexapod {

void TallyKeeper::noteRest(const Pose2& robot) {
  if (rest_) tally_.distance_m += distance(*rest_, robot);
  rest_ = robot;
}

void TallyKeeper::notePlan(const PlanResult& plan) {
  std::vector<std::size_t> entries;
  for (const PlannedStep& step : plan.steps) entries.push_back(step.entry);
  if (has_plan_ && entries != expected_) ++tally_.replans;
  has_plan_ = true;
  expected_ = entries;
  if (!expected_.empty()) expected_.erase(expected_.begin());
}

void TallyKeeper::noteStep(const Pose2& predicted, const Pose2& measured) {
  const double share = 1.0 / ++tally_.measured;
  tally_.xy_error_m += share * (distance(predicted, measured) - tally_.xy_error_m);
  tally_.yaw_error_rad += share * (headingDistance(predicted, measured) - tally_.yaw_error_rad);
}

void TallyKeeper::noteClearance(double clearance_m) {
  tally_.clearance_m = std::min(tally_.clearance_m, clearance_m);
}

WalkTally TallyKeeper::tally() const {
  WalkTally tally = tally_;
  const std::int64_t duration_ns = clock_.robotNow_ns() - begin_ns_;
  tally.duration_s = 1e-9 * static_cast<double>(std::max<std::int64_t>(0, duration_ns));
  return tally;
}

}  // namespace hexapod
