#include "planning/walk.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "arc_repertoire.h"

namespace hexapod {
namespace {

// Where a robot ends that stands at `before` and plays an entry that says `start_from_end`.
using Robot = std::function<Pose2(const Pose2& before, const Pose2& start_from_end)>;

class WalkTest : public testing::Test {
 protected:
  Walk::Decision walkWith(const Robot& robot, const Pose2& goal, int most_steps = 60) {
    Walk walk(planner_, goal, GoalTolerance());
    Pose2 pose;
    Walk::Decision decision = walk.decide(pose);
    for (int i = 0; i < most_steps && decision.state == WalkState::kStep; ++i) {
      const Entry& entry = planner_->repertoire().entries.at(decision.step->entry);
      pose = robot(pose, entry.expectedPose());
      decision = walk.decide(pose);
    }
    end_ = pose;
    steps_ = walk.stepsTaken();
    return decision;
  }

  std::shared_ptr<AdaptivePlanner> planner_ =
      std::make_shared<AdaptivePlanner>(arcRepertoire(300, 1), PlannerOptions());
  Pose2 end_;
  std::int64_t steps_ = 0;
};

const Pose2 kGoal{0.8, -0.5, 1.0};

TEST_F(WalkTest, ArrivesWithARobotThatDoesAsTheRepertoireSays) {
  const auto decision =
      walkWith([](const Pose2& before, const Pose2& step) { return before * step; }, kGoal);
  EXPECT_EQ(decision.state, WalkState::kArrived) << decision.message;
  EXPECT_LE(distance(end_, kGoal), GoalTolerance().xy_m);
  EXPECT_LE(headingDistance(end_, kGoal), GoalTolerance().yaw_rad);
  EXPECT_GT(steps_, 0);
}

TEST_F(WalkTest, PassesEveryWaypointInOrderAndArrivesAtTheLast) {
  const std::vector<Waypoint> route = {{{0.9, 0.2, 0.0}, {0.06, -1.0}},
                                       {{0.9, -0.8, 2.0}, {0.05, 0.2}},
                                       {{0.0, 0.0, 0.0}, {0.05, 0.2}}};
  Walk walk(planner_, route);
  Pose2 pose;
  std::size_t passed = 0;
  Walk::Decision decision = walk.decide(pose);
  for (int i = 0; i < 60 && decision.state == WalkState::kStep; ++i) {
    if (decision.waypoint != passed) {
      ASSERT_EQ(decision.waypoint, passed + 1);
      EXPECT_LE(distance(pose, route[passed].world_from_goal), route[passed].tolerance.xy_m);
      passed = decision.waypoint;
    }
    pose = pose * planner_->repertoire().entries.at(decision.step->entry).expectedPose();
    decision = walk.decide(pose);
  }
  EXPECT_EQ(decision.state, WalkState::kArrived) << decision.message;
  EXPECT_EQ(decision.waypoint, 2u);
  EXPECT_EQ(passed, 2u);
  EXPECT_LE(distance(pose, route[2].world_from_goal), 0.05);
  EXPECT_NE(decision.message.find("3 waypoints"), std::string::npos) << decision.message;
}

TEST_F(WalkTest, TakesNoMoreBehavioursThroughARouteThanItWasPlannedWith) {
  Random random(3);
  for (int i = 0; i < 5; ++i) {
    std::vector<Waypoint> route;
    for (int k = 0; k < 4; ++k) {
      route.push_back({{random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0), 0.0}, {0.05, -1.0}});
    }
    const RoutePlan planned = RoutePlanner(*planner_).plan(PlanRequest{}, route);
    ASSERT_TRUE(planned.success());
    Walk walk(planner_, route);
    Pose2 pose;
    Walk::Decision decision = walk.decide(pose);
    for (int k = 0; k < 60 && decision.state == WalkState::kStep; ++k) {
      pose = pose * planner_->repertoire().entries.at(decision.step->entry).expectedPose();
      decision = walk.decide(pose);
    }
    EXPECT_EQ(decision.state, WalkState::kArrived) << decision.message;
    EXPECT_LE(walk.stepsTaken(), static_cast<std::int64_t>(planned.steps()));
  }
}

TEST_F(WalkTest, IsStuckOnTheLaterWaypointThatItCannotGetTo) {
  const std::vector<Waypoint> route = {{{0.9, 0.0, 0.0}, {0.06, -1.0}}, {kGoal, GoalTolerance()}};
  Walk walk(planner_, route);
  Pose2 pose;
  Walk::Decision decision = walk.decide(pose);
  for (int i = 0; i < 60 && decision.state == WalkState::kStep; ++i) {
    if (decision.waypoint == 0) {
      pose = pose * planner_->repertoire().entries.at(decision.step->entry).expectedPose();
    }
    decision = walk.decide(pose);
  }
  EXPECT_EQ(decision.state, WalkState::kStuck);
  EXPECT_EQ(decision.waypoint, 1u);
}

TEST_F(WalkTest, ArrivesAtOnceWhenItStandsThere) {
  const auto decision = walkWith(nullptr, {0.01, 0.0, 0.02});
  EXPECT_EQ(decision.state, WalkState::kArrived);
  EXPECT_EQ(steps_, 0);
}

TEST_F(WalkTest, ArrivesWithARobotThatWalksAThirdTooFarAndTurnsTooMuch) {
  const auto decision = walkWith(
      [](const Pose2& before, const Pose2& step) {
        return before * Pose2{1.3 * step.x_m, 1.3 * step.y_m, step.yaw_rad + 0.17};
      },
      {2.0, 1.0, -2.0});
  EXPECT_EQ(decision.state, WalkState::kArrived) << decision.message;
}

TEST_F(WalkTest, IsStuckWhenTheRobotDoesNotMoveAndSaysWithWhatNumbers) {
  const auto decision = walkWith([](const Pose2& before, const Pose2&) { return before; }, kGoal);
  EXPECT_EQ(decision.state, WalkState::kStuck);
  EXPECT_LE(steps_, WalkOptions().max_failed_steps);
  EXPECT_NE(decision.message.find("measured (0.00 m, 0.00 m, 0 deg)"), std::string::npos)
      << decision.message;
}

TEST_F(WalkTest, IsStuckWhenTheRobotNeverGetsThere) {
  // A robot on a band that carries it back by what it gained.
  int step_number = 0;
  const auto decision =
      walkWith([&](const Pose2& before,
                   const Pose2& step) { return ++step_number % 2 == 1 ? before * step : Pose2(); },
               kGoal, 1000);
  EXPECT_EQ(decision.state, WalkState::kStuck) << decision.message;
}

TEST_F(WalkTest, LosesThePoseWhenItJumpsFartherThanABehaviourLeads) {
  const auto decision = walkWith(
      [](const Pose2&, const Pose2&) {
        return Pose2{7.0, 7.0, 0.0};
      },
      kGoal);
  EXPECT_EQ(decision.state, WalkState::kPoseLost);
}

// The repertoire of a robot `scale` times as large.
Repertoire scaled(double scale) {
  Repertoire repertoire = arcRepertoire(300, 1);
  for (Entry& entry : repertoire.entries) {
    for (Pose2* pose : {&entry.end_pose, &entry.execution->mean}) {
      pose->x_m *= scale;
      pose->y_m *= scale;
    }
  }
  return repertoire;
}

TEST_F(WalkTest, JudgesAJumpByTheReachOfTheRepertoire) {
  // 0.7 m along an arc is the reach of the ordinary one; no step of any of them is a jump.
  const auto walks = [](const Pose2& before, const Pose2& step) { return before * step; };
  const auto jumps = [](const Pose2&, const Pose2&) { return Pose2{0.0, 0.5, 0.0}; };
  planner_ = std::make_shared<AdaptivePlanner>(scaled(5.0), PlannerOptions());
  EXPECT_EQ(walkWith(walks, {12.0, 4.0, 1.0}).state, WalkState::kArrived);
  planner_ = std::make_shared<AdaptivePlanner>(scaled(0.1), PlannerOptions());
  EXPECT_EQ(walkWith(jumps, {0.4, 0.0, 0.0}).state, WalkState::kPoseLost);
}

TEST_F(WalkTest, LearnsNothingFromAStepItIsToldToDisregard) {
  Walk walk(planner_, kGoal, GoalTolerance());
  const auto before = planner_->planner();
  Pose2 pose;
  for (int i = 0; i < 20; ++i) {
    const auto decision = walk.decide(pose);
    ASSERT_EQ(decision.state, WalkState::kStep) << decision.message;
    pose = pose * Pose2{0.0, 0.0, 0.3};
    walk.disregardLastStep();
  }
  EXPECT_EQ(planner_->planner(), before);
}

TEST_F(WalkTest, KeepsWhatWasLearnedWhenTheRepertoireGrows) {
  const auto turns_too_much = [](const Pose2& before, const Pose2& step) {
    return before * Pose2{1.3 * step.x_m, 1.3 * step.y_m, step.yaw_rad + 0.17};
  };
  walkWith(turns_too_much, {2.0, 1.0, -2.0});
  PlanRequest request;
  request.world_from_goal = kGoal;
  const PlanResult learned = planner_->planner()->plan(request);
  const AdaptivePlanner grown(planner_->repertoire(), *planner_);
  const PlanResult after = grown.planner()->plan(request);
  ASSERT_TRUE(learned.success()) << learned.message;
  ASSERT_EQ(after.steps.size(), learned.steps.size());
  for (std::size_t i = 0; i < after.steps.size(); ++i) {
    EXPECT_EQ(after.steps[i].id, learned.steps[i].id);
    EXPECT_EQ(after.steps[i].world_from_end.x_m, learned.steps[i].world_from_end.x_m);
  }
  const AdaptivePlanner forgetful(planner_->repertoire(), PlannerOptions());
  EXPECT_NE(forgetful.planner()->plan(request).steps.front().world_from_end.x_m,
            after.steps.front().world_from_end.x_m);
}

TEST_F(WalkTest, TellsWhyThereIsNoPlan) {
  const auto invalid = walkWith(nullptr, {std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0});
  EXPECT_EQ(invalid.state, WalkState::kNoPlan);
  EXPECT_EQ(invalid.plan.code, PlanCode::kInvalidGoal);
  planner_ = std::make_shared<AdaptivePlanner>(Repertoire(), PlannerOptions());
  const auto empty = walkWith(nullptr, kGoal);
  EXPECT_EQ(empty.state, WalkState::kNoPlan);
  EXPECT_EQ(empty.plan.code, PlanCode::kNoRepertoire);
  EXPECT_FALSE(empty.message.empty());
}

}  // namespace
}  // namespace hexapod
