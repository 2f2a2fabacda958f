#include "planning/adaptive_planner.h"

namespace hexapod {

AdaptivePlanner::AdaptivePlanner(const Repertoire& repertoire, const PlannerOptions& options)
    : repertoire_(repertoire),
      options_(options),
      planner_(std::make_shared<const Planner>(repertoire_, options_)) {}

AdaptivePlanner::AdaptivePlanner(const Repertoire& repertoire, const AdaptivePlanner& earlier)
    : AdaptivePlanner(repertoire, earlier, std::lock_guard<std::mutex>(earlier.mutex_)) {}

AdaptivePlanner::AdaptivePlanner(const Repertoire& repertoire, const AdaptivePlanner& earlier,
                                 const std::lock_guard<std::mutex>&)
    : repertoire_(repertoire),
      options_(earlier.options_),
      estimator_(earlier.estimator_),
      deviation_(earlier.deviation_),
      planner_(std::make_shared<const Planner>(repertoire_, options_, deviation_)) {}

std::shared_ptr<const Planner> AdaptivePlanner::planner() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return planner_;
}

void AdaptivePlanner::observe(std::size_t entry, const Pose2& world_from_before,
                              const Pose2& world_from_after) {
  Deviation deviation;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    estimator_.observe(repertoire_.entries.at(entry).expectedPose(),
                       inverse(world_from_before) * world_from_after);
    if (estimator_.deviation() == deviation_) return;
    deviation = estimator_.deviation();
  }
  auto planner = std::make_shared<const Planner>(repertoire_, options_, deviation);
  const std::lock_guard<std::mutex> lock(mutex_);
  deviation_ = deviation;
  planner_ = std::move(planner);
}

}  // namespace hexapod
