#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ros_interface/planner/walk_goal.h"

namespace hexapod {

/// Where a robot came to rest on its walk.
struct WalkedStop {
  Pose2 measured;
  std::optional<Pose2> predicted;  ///< if a behaviour led here that was played as it is
};

/// Who is shown walks. Poses are in the global frame. From any thread.
class WalkWatcher {
 public:
  virtual ~WalkWatcher() = default;

  virtual void showGoal(const Pose2& goal) = 0;

  /// The plan from `start`, where the robot came to rest so far, the goal's ring.
  virtual void showPlan(const Pose2& start, const PlanResult& plan,
                        const std::vector<WalkedStop>& walked, const Pose2& goal,
                        double xy_tolerance_m) = 0;

  /// A goal that was refused or given up, and why.
  virtual void showRefused(const Pose2& goal, double xy_tolerance_m, const WalkReport& report) = 0;

  /// Behaviour `number` (from 1) of a goal: what was predicted and what was measured.
  virtual void reportStep(const std::string& goal_id, std::uint32_t number, const PlannedStep& step,
                          const Pose2& before, const Pose2& after) = 0;

  /// A walk has ended, however it did.
  virtual void reportWalk(const std::string& goal_id, const WalkReport& report) = 0;

  /// The robot stands although it was told to walk: a sentence that says why.
  virtual void tellStanding(const std::string& why) = 0;
};

}  // namespace hexapod
