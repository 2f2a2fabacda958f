#include "planning/adaptive_planner.h"

namespace hexapod {

AdaptivePlanner::AdaptivePlanner(const Repertoire& repertoire, const PlannerOptions& options)
    : repertoire_(repertoire),
      options_(options),
      planner_(std::make_shared<const Planner>(repertoire_, options_)) {}

std::shared_ptr<const Planner> AdaptivePlanner::planner() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return planner_;
}

void AdaptivePlanner::observe(std::size_t entry, const Pose2& world_from_before,
                              const Pose2& world_from_after) {
  estimator_.observe(repertoire_.entries.at(entry).expectedPose(),
                     inverse(world_from_before) * world_from_after);
  if (estimator_.deviation() == deviation_) return;
  deviation_ = estimator_.deviation();
  auto planner = std::make_shared<const Planner>(repertoire_, options_, deviation_);
  const std::lock_guard<std::mutex> lock(mutex_);
  planner_ = std::move(planner);
}

}  // namespace hexapod
