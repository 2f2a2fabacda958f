#include "learn_and_walk.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "gait/behavior.h"
#include "learning/learning_session.h"
#include "planning/planner.h"
#include "robot/dimensions.h"
#include "simulation/rollout.h"
#include "tools/evolve_options.h"

namespace hexapod {
namespace {

constexpr int kMostBehaviours = 30;
// Of a robot whose legs reach 0.29 m.
constexpr std::array<Pose2, 5> kGoals = {Pose2{1.0, 0.4, 0.6}, Pose2{-0.4, -0.2, 0.3},
                                         Pose2{0.2, -0.9, -1.5}, Pose2{0.8, -0.5, -1.0},
                                         Pose2{-0.7, 0.6, -0.7}};

Repertoire learn(const RobotDescription& robot, std::int64_t evaluations) {
  const std::string file =
      (std::filesystem::path(testing::TempDir()) / ("hexapod_walks_" + robot.name + ".db"))
          .string();
  LearnOptions options = evolveOptionsFrom({"--file", file, "--overwrite", "--threads", "1"}).learn;
  options.evaluations = evaluations;
  options.engine = "reduced";
  options.verify_with_ode = false;
  options.resimulate = false;
  options.validation_trials = 4;
  Repertoire repertoire;
  {
    double time_s = 0.0;
    LearningSession session(robot, options, [&] { return time_s += 1e-3; });
    session.run({});
    repertoire = session.repertoire();
  }
  std::filesystem::remove(file);
  return repertoire;
}

// Whether it arrives; counts falls.
bool walkTo(World& world, const Planner& planner, const Repertoire& repertoire,
            const PlanRequest& goal, Walks& walks) {
  const BehaviorOptions behavior;
  for (int count = 0; count < kMostBehaviours; ++count) {
    PlanRequest request = goal;
    request.world_from_start = footprint(world.worldFromBase());
    const PlanResult plan = planner.plan(request);
    if (plan.code == PlanCode::kAlreadyThere) return true;
    if (plan.code != PlanCode::kFound) return false;
    const Genome& genome = repertoire.entries[plan.steps.front().entry].genome;
    if (!play(world, Behavior(world.robot(), genome, behavior), behavior.command_period_s)
             .walked()) {
      ++walks.falls;
      return false;
    }
  }
  return false;
}

}  // namespace

Walks learnAndWalk(const RobotDescription& robot, std::int64_t evaluations) {
  const Repertoire repertoire = learn(robot, evaluations);
  const double scale = lengthScale(robot);
  PlannerOptions options;
  options.planning_time_s = 10.0;  // no clock decides here
  options.max_pairs = 40000;
  const Planner planner(repertoire, options);
  const auto world = makeWorld(Engine::kReduced, robot, Physics{});
  Walks walks;
  walks.entries = repertoire.entries.size();
  for (const Pose2& goal : kGoals) {
    world->restart();
    PlanRequest request;
    request.world_from_goal = {scale * goal.x_m, scale * goal.y_m, goal.yaw_rad};
    request.tolerance = {0.06 * std::max(1.0, scale), 0.2};
    ++walks.goals;
    walks.reached += walkTo(*world, planner, repertoire, request, walks) ? 1 : 0;
  }
  return walks;
}

}  // namespace hexapod
