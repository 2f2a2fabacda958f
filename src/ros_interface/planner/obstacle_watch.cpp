#include "ros_interface/planner/obstacle_watch.h"

#include <algorithm>

namespace hexapod {

const std::shared_ptr<const Obstacles>& ObstacleWatch::look() {
  seen_ = source_ ? source_() : nullptr;
  return seen_;
}

bool ObstacleWatch::touchesNews(const Planner& planner, const Pose2& world_from_start,
                                std::size_t entry) {
  if (!isOutdated() || !look()) return false;
  // A plan may have been made for a narrow passage.
  const Obstacles& narrow = *seen_->narrow();
  const double stood_m = std::min(0.0, narrow.clearance_m(world_from_start));
  return planner.clearance_m(narrow, world_from_start, entry) < stood_m;
}

}  // namespace hexapod
