#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "ros_interface/common/clock.h"
#include "ros_interface/planner/planner_node_options.h"
#include "ros_interface/planner/repertoire_in_use.h"
#include "ros_interface/planner/walk_goal.h"
#include "ros_interface/robot_client/pose_source.h"

namespace hexapod {

/// Says of a goal whether it can be walked to from where the robot stands, or why not. Moves
/// nothing, publishes nothing. From any thread; ends soon after `stop` is true.
class GoalExaminer {
 public:
  /// What it needs of the node; all of it must outlive it.
  struct Means {
    const PlannerNodeOptions& options;
    const Clock& clock;
    const PoseSource& poses;
    const RepertoireInUse& repertoire;
    const BehaviorPlayer& player;
    ObstacleSource obstacles = {};          ///< may be empty
    ObstacleProblem obstacle_problem = {};  ///< may be empty
  };
  using Stop = std::function<bool()>;

  struct Examination {
    WalkReport report;  ///< a refusal unless it is a success; then with the plan
    WalkGoal goal;
    bool is_goal_known = false;  ///< it could be read
    Pose2 start;
    PlanResult plan;
  };

  explicit GoalExaminer(const Means& means);

  Examination examine(const GoalRequest& request, const Stop& stop) const;

  /// The same from another start, given in any frame.
  Examination examineFrom(const geometry_msgs::PoseStamped& start, const GoalRequest& request,
                          const Stop& stop) const;

 private:
  using Refusal = std::optional<WalkReport>;

  Refusal readGoal(const GoalRequest& request, const Stop& stop, WalkGoal& goal) const;
  Refusal readPose(const PoseRequest& request, const Stop& stop, Waypoint& waypoint) const;
  Examination examineTwist(const Stop& stop) const;
  Refusal askPlayer(const Stop& stop) const;
  Refusal askMap(const Stop& stop) const;
  Refusal askRepertoire(const Stop& stop) const;
  bool cannotBePlayed() const;
  void plan(const Stop& stop, Examination& examination) const;
  PlanResult planRoute(const AdaptivePlanner& planner, PlanRequest request,
                       const std::vector<Waypoint>& route) const;
  void awaitAtStart(const std::function<bool()>& there, const Stop& stop) const;

  Means means_;
  std::int64_t start_ns_;
};

}  // namespace hexapod
