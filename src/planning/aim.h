#pragma once

#include "planning/plan.h"

namespace hexapod {

/// What is settled before a chain is searched among obstacles: whether the robot stands free,
/// whether it can at the goal, and which ways lead there. Fills in the ways, and with
/// GoalPolicy::kNearest the target where that is not the goal. False when there is nothing left to
/// search: code and nearest pose say why.
bool aim(const PlanRequest& request, PlanResult& result);

/// Where a plan ends, seen from its target.
void measureTo(const Pose2& world_from_end, PlanResult& result);

/// Whether it ends, as measured, within the tolerance.
bool isWithin(const GoalTolerance& tolerance, const PlanResult& result);

}  // namespace hexapod
