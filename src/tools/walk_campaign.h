#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "planning/adaptive_planner.h"
#include "repertoire/repertoire.h"
#include "robot/robot_description.h"
#include "self_model/learned_world.h"
#include "self_model/self_model.h"
#include "simulation/world.h"

namespace hexapod {

/// Which goals are walked to, and how a robot that walks there sees itself.
struct CampaignOptions {
  std::int64_t goals = 300;  ///< per body
  std::int64_t seed = 1;     ///< of the goals, the same for every body
  std::int64_t threads = 0;
  double radius_m = 2.0;  ///< goals are uniform in this disc, any heading
  double xy_tolerance_m = 0.03;
  double yaw_tolerance_rad = 0.0873;
  std::int64_t max_behaviors = 40;
  double measurement_noise_m = 0.0;    ///< standard deviation of a measured position, per axis
  double measurement_noise_rad = 0.0;  ///< and of a measured heading
  std::string engine = "reduced";      ///< of the world that is walked in
  std::int64_t relearn_evaluations = 30000;
  /// What is told of a body is not quite so: friction and torque are told higher by this share,
  /// servo gain and mass lower.
  double told_error = 0.0;
  bool keep_belief = false;  ///< one walk from goal to goal; the first one is not counted
};

std::vector<Option> declareOptions(CampaignOptions& options);

/// How the robot adapts: choices of a campaign.
enum class Adaptation {
  kNone,       ///< the repertoire is taken at its word
  kDeviation,  ///< one deviation of all behaviours
  kSelfModel,  ///< SelfModel, with a fresh belief for every goal
  kTold,       ///< SelfModel that is told the body: the ceiling
  kRelearned   ///< the same with the repertoire relearned for that body
};
const std::vector<std::string>& adaptationNames();
Adaptation adaptationFromText(const std::string& name);

/// A robot that is otherwise than the one learned with.
struct TrueBody {
  std::string name;
  Physics physics;
};

/// How the walk to one goal went.
struct GoalWalk {
  enum class End { kArrived, kGivenUp, kNoPlan, kFell, kLegsTouched };
  End end = End::kGivenUp;
  int behaviors = 0;
  std::vector<double> off_m, off_rad;  ///< of the end poses from the predicted ones
  /// Processor time that was spent on each behaviour after it: on the belief, on what it expects of
  /// the repertoire, on the planner's tables; all in one thread.
  std::vector<double> thought_s;
  /// The right legs, in whatever way, are believed out of order after the first behaviour.
  bool right_after_first = false;
  bool false_alarm = false;  ///< of an intact robot: once believed damaged
};

/// Walks from the stand to every goal, planned anew after each behaviour, in the core without ROS;
/// with keep_belief from one goal to the next, each relative to where the robot stands.
/// Deterministic, whatever the number of threads.
std::vector<GoalWalk> walkToGoals(const RobotDescription& robot, const Repertoire& repertoire,
                                  const TrueBody& body, Adaptation adaptation,
                                  const CampaignOptions& options);

/// Sums and shares over the goals of one row.
struct CampaignRow {
  std::int64_t goals = 0, arrived = 0, given_up = 0, no_plan = 0, fell = 0, touched = 0;
  double behaviors = 0.0;  ///< per goal that was reached
  double off_m = 0.0;      ///< median over all behaviours but the first two of a goal
  double off_rad = 0.0;
  double right_after_first = 0.0;  ///< share of the goals
  double false_alarms = 0.0;
  double thought_s = 0.0;       ///< median over all behaviours
  double most_thought_s = 0.0;  ///< what 95 % of them stay below
};
CampaignRow summarize(const std::vector<GoalWalk>& walks);

}  // namespace hexapod
