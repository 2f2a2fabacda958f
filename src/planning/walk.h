#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "planning/adaptive_planner.h"
#include "planning/route_planner.h"

namespace hexapod {

/// How a walk ended, or that it goes on.
enum class WalkState {
  kStep,     ///< play Decision::step next
  kArrived,  ///< within tolerance
  kNoPlan,   ///< Decision::plan tells why
  kStuck,    ///< the behaviours do not move the robot as predicted
  kPoseLost  ///< the measured pose jumped farther than any behaviour of the repertoire leads
};

/// When a walk is given up.
struct WalkOptions {
  /// A behaviour failed when it ended this share of its predicted displacement (a radian counts as
  /// 0.3 m) away from its prediction, and more than the spreads explain.
  double failed_share = 0.7;
  std::int64_t max_failed_steps = 4;  ///< in a row: stuck
  std::int64_t max_steps_factor = 4;  ///< steps beyond this many times the first plan + 10: stuck
  /// Moved this many times as far as the farthest entry leads, the robot did not walk: its pose
  /// jumped.
  double jump_reaches = 2.5;
  GoalPolicy goal_policy = GoalPolicy::kRefuse;
};

/// One walk to a goal, or through several, behaviour by behaviour, planned anew from the measured
/// pose before each one, with the plan before for a start. A waypoint is passed when the robot
/// comes to rest within its tolerance; that a later one cannot be reached is no reason not to go to
/// it.
///
/// Knows no clock and no robot: decide() is told where the robot stands at rest and answers what to
/// play. Not thread-safe.
class Walk {
 public:
  struct Decision {
    WalkState state = WalkState::kNoPlan;
    PlanResult plan;                  ///< from the measured pose
    std::optional<PlannedStep> step;  ///< only with kStep: the first of the plan
    std::size_t waypoint = 0;         ///< that is walked to
    std::string message;              ///< a sentence for the user
  };

  /// The planner is shared with other walks: what is learned of the robot in one serves the next.
  Walk(std::shared_ptr<AdaptivePlanner> planner, const Pose2& world_from_goal,
       const GoalTolerance& tolerance, const WalkOptions& options = {});
  /// Through these, one after the other; at least one.
  Walk(std::shared_ptr<AdaptivePlanner> planner, std::vector<Waypoint> route,
       const WalkOptions& options = {});

  /// The next behaviour, or the end. `stop` may end the planning early (PlanRequest::stop).
  Decision decide(const Pose2& world_from_robot, const std::function<bool()>& stop = {});

  /// Where the robot may be from the next decision on; null: everywhere.
  void setObstacles(std::shared_ptr<const Obstacles> obstacles) {
    obstacles_ = std::move(obstacles);
  }

  /// The behaviour of the last decision was not played as it is: where it led says nothing of the
  /// repertoire, so the next decide() neither learns from it nor counts it as failed.
  void disregardLastStep() {
    expected_.reset();
    memory_ = {};
  }

  /// How far the joints moved in the behaviour of the last decision, for the next decide() to learn
  /// from.
  void noteJoints(std::vector<JointRange> joints) { joints_ = std::move(joints); }

  std::int64_t stepsTaken() const { return steps_taken_; }

 private:
  PlanResult planOnward(const PlanRequest& request);
  bool isAt(const Waypoint& waypoint, const Pose2& world_from_robot) const;
  void pass();
  std::string describeArrival(const Pose2& world_from_robot, const PlanResult& plan) const;
  std::optional<std::string> problemWith(const Pose2& world_from_robot, WalkState& state);

  std::shared_ptr<AdaptivePlanner> planner_;
  std::vector<Waypoint> route_;
  std::size_t at_ = 0;  // the waypoint that is walked to
  WalkOptions options_;
  std::int64_t steps_taken_ = 0;
  std::int64_t failed_in_a_row_ = 0;
  static constexpr std::int64_t kUnknown = std::numeric_limits<std::int64_t>::max();
  std::int64_t most_steps_ = kUnknown;  // until the first plan to the waypoint
  std::optional<PlannedStep> expected_;
  Pose2 before_;
  std::vector<JointRange> joints_;  // of expected_
  std::shared_ptr<const Obstacles> obstacles_;
  RouteMemory memory_;  // of the last plan, whose first step is expected_
};

}  // namespace hexapod
