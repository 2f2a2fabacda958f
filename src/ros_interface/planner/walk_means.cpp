#include "ros_interface/planner/walk_means.h"

#include <utility>

namespace hexapod {

std::function<bool()> withinWallTime(const PlannerNodeOptions& options, const Clock& clock,
                                     std::function<bool()> stop, std::size_t plans) {
  if (options.planning_wall_time_s <= 0.0) return stop;
  const std::int64_t until_ns =
      clock.steadyNow_ns() + secondsToNs(static_cast<double>(plans) * options.planning_wall_time_s);
  return [stop = std::move(stop), &clock, until_ns] {
    return (stop && stop()) || clock.steadyNow_ns() > until_ns;
  };
}

}  // namespace hexapod
