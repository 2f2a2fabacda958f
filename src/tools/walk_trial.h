#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gait/behavior_options.h"
#include "planning/walk.h"
#include "simulation/world.h"
#include "tools/plan_trial.h"

namespace hexapod {

/// A walk of the simulated robot and what was measured of it.
struct WalkTrial {
  Walk::Decision end;
  std::int64_t behaviors = 0;
  double distance_m = 0.0;  ///< of the pose in the end from the goal
  double heading_rad = 0.0;
  /// Smallest distance between the bodies of the robot as they were, at each command, and occupied
  /// cells; negative: they overlap [m].
  double clearance_m = 0.0;
};

/// Walks from the start of a task to its goal, as planner and executor do: plan, play the first
/// behaviour, plan anew from where the robot stands.
WalkTrial walkThrough(World& world, const std::shared_ptr<AdaptivePlanner>& planner,
                      const BehaviorOptions& behavior, const PlanTask& task);

/// One line of the report in the columns of kWalkHeading.
std::string describe(const std::string& name, const std::vector<WalkTrial>& trials);
extern const char* const kWalkHeading;

}  // namespace hexapod
