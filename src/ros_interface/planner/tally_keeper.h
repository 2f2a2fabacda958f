#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "planning/plan.h"
#include "ros_interface/common/clock.h"
#include "ros_interface/planner/walk_goal.h"

namespace hexapod {

/// Keeps the tally of one walk. Used by one thread.
class TallyKeeper {
 public:
  /// The walk begins. The clock must outlive it.
  explicit TallyKeeper(const Clock& clock) : clock_(clock), begin_ns_(clock.robotNow_ns()) {}

  /// Where the robot is after a behaviour.
  void noteRest(const Pose2& robot);
  /// What the plan made there says.
  void notePlan(const PlanResult& plan);
  /// A behaviour was played as it is.
  void noteStep(const Pose2& predicted, const Pose2& measured);
  /// On the way.
  void noteClearance(double clearance_m);

  WalkTally tally() const;

 private:
  const Clock& clock_;
  std::int64_t begin_ns_;
  WalkTally tally_;
  std::vector<std::size_t> expected_;  // entries left of the last plan
  bool has_plan_ = false;
  std::optional<Pose2> rest_;
};

}  // namespace hexapod
