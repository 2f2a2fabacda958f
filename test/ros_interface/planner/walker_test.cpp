#include "ros_interface/planner/walker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "planning/arc_repertoire.h"
#include "planning/deviation.h"
#include "ros_interface/fake_clock.h"
#include "ros_interface/planner/fakes.h"

namespace hexapod {
namespace {

hexapod_repertoire::Repertoire arcMessage() {
  Repertoire repertoire = arcRepertoire(300, 1);
  repertoire.run_id = "run";
  repertoire.behavior_duration_s = 3.9;
  return toMsg(repertoire, ros::Time(1.0));
}

// Walks with an executor, a pose and a clock that are made up: no master, no waiting.
class WalkerTest : public testing::Test {
 protected:
  WalkerTest() { repertoire_.take(arcMessage(), "/server"); }

  void submit(Client& client, const GoalRequest& request, const std::string& id = "") {
    walker_->submit(request, client.listener(), id);
  }
  WalkReport walk(const GoalRequest& request) {
    Client client;
    submit(client, request);
    WalkReport report = client.waitForEnd();
    EXPECT_EQ(client.ends(), 1u);
    return report;
  }

  void cancelInMidBehaviour() {
    player_.held = true;
    Client client;
    submit(client, goalAt(3.0, 0.0, 0.0));
    while (player_.begun == 0) std::this_thread::yield();
    walker_->cancelAll();
    client.waitForEnd();
  }

  PlannerNodeOptions options_;
  FakeClock clock_;
  FakePoseSource poses_;
  FakePlayer player_{poses_};
  FakeWatcher watcher_;
  RepertoireInUse repertoire_{PlannerOptions(), "", [] { return std::vector<std::string>(); }};
  std::unique_ptr<Walker> walker_ = std::make_unique<Walker>(
      Walker::Means{options_, clock_, poses_, repertoire_, player_, watcher_});
};

TEST_F(WalkerTest, WalksToAGoalAndReportsEveryBehaviour) {
  poses_.set({Pose2{0.3, -0.2, 0.7}, ""});
  Client client;
  submit(client, goalAt(1.2, 0.9, -1.0));
  const WalkReport report = client.waitForEnd();
  EXPECT_EQ(report.code, GoalCode::SUCCEEDED) << report.message;
  EXPECT_TRUE(client.wasAccepted());
  EXPECT_GT(report.steps, 1u);
  EXPECT_EQ(watcher_.steps, static_cast<int>(report.steps));
  EXPECT_EQ(player_.begun, static_cast<int>(report.steps));
  EXPECT_LE(distance(*poses_.latest().pose, {1.2, 0.9, -1.0}), options_.planner.xy_tolerance_m);
  EXPECT_NEAR(report.final_pose.pose.position.x, poses_.latest().pose->x_m, 1e-12);
  EXPECT_LE(report.final_xy_error_m, options_.planner.xy_tolerance_m);
  EXPECT_NEAR(report.plan.poses.front().pose.position.x, 0.3, 1e-9);
}

TEST_F(WalkerTest, SumsUpThePlanAndTheWalk) {
  const WalkReport report = walk(goalAt(1.2, 0.9, -1.0));
  const auto& plan = report.plan_summary;
  EXPECT_EQ(plan.steps, report.steps) << "a robot that does as predicted walks its plan";
  EXPECT_GE(plan.steps, plan.at_least_steps);
  EXPECT_GT(plan.at_least_steps, 1u);
  EXPECT_GE(plan.length_m, 1.5);  // the straight line
  EXPECT_NEAR(plan.duration_s, 3.9 * plan.steps, 1e-9);
  EXPECT_TRUE(std::isinf(plan.clearance_m)) << "without a map";
  EXPECT_EQ(report.nearest_pose.header.frame_id, "odom");
  walker_.reset();  // all is told
  ASSERT_EQ(watcher_.walks().size(), 1u);
  const WalkReport summary = watcher_.walks().front();
  EXPECT_EQ(summary.code, GoalCode::SUCCEEDED);
  EXPECT_EQ(summary.steps, report.steps);
  EXPECT_LT(summary.tally.xy_error_m, 1e-9);
  EXPECT_GE(summary.tally.distance_m, 1.5 - options_.planner.xy_tolerance_m);
}

TEST_F(WalkerTest, WalksThroughTheWaypointsOfARouteAndTellsHowMany) {
  GoalRequest request = goalAt(0.0, 0.0, 0.0);
  request.via = {goalAt(1.0, 0.3, 0.0), goalAt(0.8, -0.8, 2.0)};
  const WalkReport report = walk(request);
  EXPECT_EQ(report.code, GoalCode::SUCCEEDED) << report.message;
  EXPECT_EQ(report.waypoints, 3u);
  EXPECT_EQ(watcher_.goals, 3);
  EXPECT_EQ(report.plan_summary.steps, report.steps);
  EXPECT_LE(distance(*poses_.latest().pose, {0.0, 0.0, 0.0}), options_.planner.xy_tolerance_m);
}

TEST_F(WalkerTest, RefusesARouteNamingTheWaypointThatCannotBeHad) {
  GoalRequest request = goalAt(0.0, 0.0, 0.0);
  request.via = {goalAt(1.0, 0.3, 0.0), goalAt(1000.0, 0.0, 0.0)};
  const WalkReport far = walk(request);
  EXPECT_EQ(far.code, GoalCode::INVALID_GOAL);
  EXPECT_EQ(far.message.find("Waypoint 2 of 3: "), 0u) << far.message;
  request.via[1].xy_tolerance_m = -1.0;
  EXPECT_EQ(walk(request).message.find("Waypoint 2 of 3: "), 0u);
  request.problem = "No waypoints.";
  EXPECT_EQ(walk(request).message, "No waypoints.");
  EXPECT_EQ(player_.begun, 0);
}

TEST_F(WalkerTest, ACancelOnTheWayEndsTheWholeRoute) {
  player_.held = true;
  GoalRequest request = goalAt(3.0, 0.0, 0.0);
  request.via = {goalAt(2.0, 1.0, 0.0)};
  Client client;
  submit(client, request);
  while (player_.begun == 0) std::this_thread::yield();
  walker_->cancelAll();
  EXPECT_EQ(client.waitForEnd().code, GoalCode::PREEMPTED);
  player_.held = false;
  walker_.reset();
  EXPECT_EQ(player_.begun, 1);
}

TEST_F(WalkerTest, JudgesWhereTheRobotIsWhenItStandsNotWhereItPasses) {
  player_.returning = true;  // from a behaviour that was broken off
  Client client;
  submit(client, goalAt(0.0, 0.0, 0.0));
  client.waitForAcceptance();
  poses_.set({Pose2{0.4, 0.1, 0.5}, ""});
  player_.returning = false;
  const WalkReport report = client.waitForEnd();
  EXPECT_EQ(report.code, GoalCode::SUCCEEDED) << report.message;
  EXPECT_GT(player_.begun, 0);
  EXPECT_LE(distance(*poses_.latest().pose, {0.0, 0.0, 0.0}), options_.planner.xy_tolerance_m);
}

TEST_F(WalkerTest, APoseThatIsLostWhileTheRobotComesToRestIsTold) {
  player_.returning = true;
  Client client;
  submit(client, goalAt(1.0, 0.0, 0.0));
  client.waitForAcceptance();
  const int looks = poses_.looks;
  poses_.set({std::nullopt, "The robot's pose is lost.", 14 * kSecond_ns / 10});
  clock_.pass(60 * kSecond_ns);  // nobody looked meanwhile
  while (poses_.looks < looks + 3) std::this_thread::yield();
  EXPECT_EQ(client.ends(), 0u);
  poses_.set({std::nullopt, "The robot's pose is lost.", 16 * kSecond_ns / 10});
  EXPECT_EQ(client.waitForEnd().code, GoalCode::POSE_LOST);
  EXPECT_EQ(player_.begun, 0);
}

TEST_F(WalkerTest, APoseThatIsLostForAMomentThenDoesNotMakeAPassingOneCount) {
  player_.returning = true;
  Client client;
  submit(client, goalAt(0.0, 0.0, 0.0));
  client.waitForAcceptance();
  const int looks = poses_.looks;
  poses_.set({std::nullopt, "The robot's pose is lost."});
  while (poses_.looks < looks + 2) std::this_thread::yield();
  poses_.set({Pose2(), ""});  // at the goal, in passing
  while (poses_.looks < looks + 4) std::this_thread::yield();
  EXPECT_EQ(client.ends(), 0u);
  poses_.set({Pose2{0.4, 0.1, 0.5}, ""});
  player_.returning = false;
  EXPECT_EQ(client.waitForEnd().code, GoalCode::SUCCEEDED);
  EXPECT_GT(player_.begun, 0);
}

TEST_F(WalkerTest, ACancelWhileTheRobotComesToRestIsNotLost) {
  player_.returning = true;
  Client client;
  submit(client, goalAt(1.0, 0.0, 0.0));
  client.waitForAcceptance();
  EXPECT_TRUE(walker_->cancelAll());
  EXPECT_EQ(client.waitForEnd().code, GoalCode::PREEMPTED);
  walker_.reset();
  EXPECT_EQ(player_.begun, 0);
}

// Takes its time over what it has seen.
class Ponderer : public DeviationForesight {
 public:
  explicit Ponderer(const std::atomic<bool>& ponders) : ponders_(ponders) {}
  void observe(const WalkedStep&) override {
    while (ponders_) std::this_thread::yield();
  }

 private:
  const std::atomic<bool>& ponders_;
};

TEST_F(WalkerTest, TellsThatTheExecutorCannotGoOnWhileTheWalkThinks) {
  std::atomic<bool> ponders{true};
  RepertoireInUse repertoire(
      PlannerOptions(), "", [] { return std::vector<std::string>(); },
      [&](const Repertoire&) { return std::make_shared<Ponderer>(ponders); });
  repertoire.take(arcMessage(), "/server");
  walker_ = std::make_unique<Walker>(
      Walker::Means{options_, clock_, poses_, repertoire, player_, watcher_});
  Client client;
  submit(client, goalAt(3.0, 0.0, 0.0));
  while (watcher_.steps == 0) walker_->look();
  player_.becomeUnready("The executor reports a fault.");
  while (client.ends() == 0) walker_->look();
  const WalkReport report = client.waitForEnd();
  EXPECT_EQ(report.code, GoalCode::EXECUTOR_NOT_READY);
  EXPECT_NE(report.message.find("reports a fault"), std::string::npos) << report.message;
  EXPECT_EQ(report.steps, 1u);
  ponders = false;
  walker_.reset();
  EXPECT_EQ(client.ends(), 1u);
  EXPECT_EQ(player_.begun, 1);
}

TEST_F(WalkerTest, ShowsWhereEachBehaviourWasPredictedToEndAndWhereItDid) {
  const WalkReport report = walk(goalAt(1.2, 0.9, -1.0));
  walker_.reset();  // all is shown
  const std::vector<WalkedStop> stops = watcher_.stops();
  ASSERT_EQ(stops.size(), report.steps + 1u);
  EXPECT_FALSE(stops.front().predicted) << "it stood there";
  for (std::size_t i = 1; i < stops.size(); ++i) {
    ASSERT_TRUE(stops[i].predicted);
    EXPECT_LT(distance(*stops[i].predicted, stops[i].measured), 1e-9) << "as the fake robot walks";
  }
  EXPECT_TRUE(watcher_.refused().empty());
}

TEST_F(WalkerTest, ShowsGoalsThatAreRefusedButNotThoseCalledOff) {
  player_.becomeUnready("Disarmed; call ~arm.");
  walk(goalAt(1.0, 0.0, 0.0));
  player_.becomeUnready("");
  cancelInMidBehaviour();
  walker_.reset();
  ASSERT_EQ(watcher_.refused().size(), 1u);
  EXPECT_EQ(watcher_.refused().front().code, GoalCode::EXECUTOR_NOT_READY);
}

TEST_F(WalkerTest, SumsUpACancelledWalkAsSuch) {
  cancelInMidBehaviour();
  walker_.reset();
  ASSERT_EQ(watcher_.walks().size(), 1u);
  EXPECT_EQ(watcher_.walks().front().code, GoalCode::PREEMPTED);
}

TEST_F(WalkerTest, RefusesAtOnceWhatCannotBeExecutedAndSaysWhatToDo) {
  player_.becomeUnready("The executor is disarmed; call executor/arm.");
  Client client;
  submit(client, goalAt(1.0, 0.0, 0.0));
  const WalkReport report = client.waitForEnd();
  EXPECT_EQ(report.code, GoalCode::EXECUTOR_NOT_READY);
  EXPECT_NE(report.message.find("executor/arm"), std::string::npos);
  EXPECT_FALSE(client.wasAccepted());
  EXPECT_EQ(player_.begun, 0);
}

TEST_F(WalkerTest, RefusesBadGoalsWithTheirReason) {
  GoalRequest bad = goalAt(1.0, 0.0, 0.0);
  bad.xy_tolerance_m = -1.0;
  EXPECT_EQ(walk(bad).code, GoalCode::INVALID_GOAL);
  bad.xy_tolerance_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(walk(bad).code, GoalCode::INVALID_GOAL);
  EXPECT_EQ(walk(goalAt(std::numeric_limits<double>::infinity(), 0.0, 0.0)).code,
            GoalCode::INVALID_GOAL);
  EXPECT_EQ(walk(goalAt(1000.0, 0.0, 0.0)).code, GoalCode::INVALID_GOAL);
  poses_.set({std::nullopt, "The robot's pose is lost."});
  EXPECT_EQ(walk(goalAt(1.0, 0.0, 0.0)).code, GoalCode::POSE_LOST);
  EXPECT_EQ(player_.begun, 0);
}

TEST_F(WalkerTest, ACancelWhileAGoalIsExaminedIsNotLost) {
  poses_.held_x_m = 5.0;
  Client client;
  submit(client, goalAt(5.0, 0.0, 0.0));
  EXPECT_TRUE(walker_->cancelAll());
  EXPECT_EQ(client.waitForEnd().code, GoalCode::PREEMPTED);
  EXPECT_FALSE(walker_->cancelAll());
  walker_.reset();
  EXPECT_EQ(client.ends(), 1u);
  EXPECT_EQ(player_.begun, 0);
}

TEST_F(WalkerTest, AGoalSentBeforeAllWereCancelledThatComesAfterIsCancelled) {
  const auto sentAt = [](double time_s) {
    GoalRequest request = goalAt(0.5, 0.2, 0.5);
    request.sent = ros::Time(time_s);
    return request;
  };
  clock_.setRos(1000.0);
  EXPECT_FALSE(walker_->cancelAll());
  clock_.pass(kSecond_ns / 20);
  EXPECT_EQ(walk(sentAt(999.99)).code, GoalCode::PREEMPTED);
  EXPECT_EQ(player_.begun, 0);
  EXPECT_EQ(walk(sentAt(1000.01)).code, GoalCode::SUCCEEDED);
  EXPECT_EQ(walk(goalAt(0.0, 0.0, 0.0)).code, GoalCode::SUCCEEDED)
      << "nobody knows when it was sent";
  // By another clock it may have been sent later.
  walker_->cancelAll();
  clock_.pass(kSecond_ns);
  EXPECT_EQ(walk(sentAt(999.99)).code, GoalCode::SUCCEEDED);
}

TEST_F(WalkerTest, ACancelInMidBehaviourIsAnsweredAndBreaksItOff) {
  player_.held = true;
  Client client;
  submit(client, goalAt(3.0, 0.0, 0.0), "far");
  while (player_.begun == 0) std::this_thread::yield();
  EXPECT_TRUE(walker_->cancel("far"));
  EXPECT_EQ(client.waitForEnd().code, GoalCode::PREEMPTED);
  // The next goal is walked to as if nothing had been.
  player_.held = false;
  EXPECT_EQ(walk(goalAt(0.5, 0.2, 0.5)).code, GoalCode::SUCCEEDED);
  EXPECT_FALSE(client.heardProgressAfterTheEnd());
  EXPECT_EQ(client.ends(), 1u);
}

TEST_F(WalkerTest, AnOlderGoalThatTakesLongerToExamineNeverWins) {
  poses_.held_x_m = 5.0;
  Client older, newer;
  submit(older, goalAt(5.0, 0.0, 0.0));
  submit(newer, goalAt(0.4, 0.1, 0.4));
  EXPECT_EQ(newer.waitForEnd().code, GoalCode::SUCCEEDED);
  poses_.releaseGoals();
  EXPECT_EQ(older.waitForEnd().code, GoalCode::PREEMPTED);
  walker_.reset();
  EXPECT_FALSE(older.wasAccepted());
  EXPECT_LE(distance(*poses_.latest().pose, {0.4, 0.1, 0.4}), options_.planner.xy_tolerance_m);
}

TEST_F(WalkerTest, TheNewestGoalTakesOverWhenTheBehaviourHasEnded) {
  player_.held = true;
  Client older, newer;
  submit(older, goalAt(6.0, 0.0, 0.0));
  while (player_.begun == 0) std::this_thread::yield();
  submit(newer, goalAt(0.8, 0.4, 0.9));
  newer.waitForAcceptance();
  EXPECT_EQ(older.ends(), 0u);
  player_.held = false;
  EXPECT_EQ(older.waitForEnd().code, GoalCode::PREEMPTED);
  EXPECT_EQ(older.waitForEnd().steps, 1u);
  EXPECT_EQ(newer.waitForEnd().code, GoalCode::SUCCEEDED);
}

TEST_F(WalkerTest, AGoalGivenBeforeAStopDoesNotBeginAfterIt) {
  player_.held = true;
  Client walked, waiting;
  submit(walked, goalAt(6.0, 0.0, 0.0));
  while (player_.begun == 0) std::this_thread::yield();
  submit(waiting, goalAt(1.0, 0.0, 0.0));
  waiting.waitForAcceptance();
  player_.becomeUnready("stopped");
  player_.becomeUnready("");  // somebody armed at once
  player_.held = false;
  EXPECT_EQ(waiting.waitForEnd().code, GoalCode::EXECUTOR_NOT_READY);
  EXPECT_EQ(waiting.waitForEnd().steps, 0u);
}

TEST_F(WalkerTest, TellsWhatEndedAWalk) {
  using End = BehaviorPlayer::End;
  for (const auto& [end, code] : {std::pair{End::kFault, GoalCode::EXECUTOR_FAULT},
                                  std::pair{End::kCancelled, GoalCode::EXECUTOR_FAULT},
                                  std::pair{End::kNotReady, GoalCode::EXECUTOR_NOT_READY},
                                  std::pair{End::kTimeStands, GoalCode::POSE_LOST}}) {
    player_.outcome = [end = end] { return BehaviorPlayer::Result{end, "because", {}, 0}; };
    const WalkReport report = walk(goalAt(2.0, 0.0, 0.0));
    EXPECT_EQ(report.code, code);
    EXPECT_NE(report.message.find("because"), std::string::npos);
    EXPECT_EQ(report.steps, 0u);
  }
}

TEST_F(WalkerTest, ALostPoseIsToldInMidBehaviourBeforeTheExecutorAnswers) {
  player_.held = true;
  player_.deaf = true;
  Client client;
  submit(client, goalAt(3.0, 0.0, 0.0));
  while (player_.begun == 0) std::this_thread::yield();
  poses_.set({std::nullopt, "The robot's pose is lost.", 16 * kSecond_ns / 10});
  EXPECT_EQ(client.waitForEnd().code, GoalCode::POSE_LOST);
  player_.deaf = false;
}

TEST_F(WalkerTest, DoesNotLearnFromABehaviourOfWhichCommandsWereSkipped) {
  const auto planner = repertoire_.planner();
  const auto before = planner->planner();
  player_.outcome = [this] {
    // What was played led somewhere else, again and again.
    poses_.set({*poses_.latest().pose * Pose2{0.05, 0.02, 0.3}, ""});
    return BehaviorPlayer::Result{BehaviorPlayer::End::kPlayed, "", ros::Time(1.0), 17};
  };
  walk(goalAt(0.9, 0.3, 0.5));
  EXPECT_EQ(watcher_.steps, 0);
  EXPECT_GT(player_.begun, 1);
  EXPECT_EQ(planner->planner(), before);
}

TEST_F(WalkerTest, PlanOnlyIsShownAndMovesNothing) {
  player_.becomeUnready("disarmed");
  GoalRequest request = goalAt(1.0, 0.5, 0.0);
  request.plan_only = true;
  const WalkReport report = walk(request);
  EXPECT_EQ(report.code, GoalCode::SUCCEEDED) << report.message;
  EXPECT_GT(report.plan.poses.size(), 10u);
  EXPECT_EQ(watcher_.plans, 1);
  EXPECT_EQ(player_.begun, 0);
}

TEST_F(WalkerTest, LeavingAnswersEverybodyAndBeginsNothing) {
  player_.held = true;
  poses_.held_x_m = 5.0;
  Client walked, waiting, examined;
  submit(walked, goalAt(3.0, 0.0, 0.0));
  while (player_.begun == 0) std::this_thread::yield();
  submit(waiting, goalAt(1.0, 0.0, 0.0));
  waiting.waitForAcceptance();
  submit(examined, goalAt(5.0, 0.0, 0.0));
  walker_->close(GoalCode::SHUTDOWN, "The planner is shutting down.");
  for (Client* client : {&walked, &waiting, &examined}) {
    EXPECT_EQ(client->waitForEnd().code, GoalCode::SHUTDOWN);
    EXPECT_EQ(client->ends(), 1u);
  }
  Client late;
  submit(late, goalAt(1.0, 0.0, 0.0));
  EXPECT_EQ(late.waitForEnd().code, GoalCode::SHUTDOWN);
  walker_.reset();
  EXPECT_EQ(player_.begun, 1);
}

TEST_F(WalkerTest, WalksByVelocityUntilItEnds) {
  std::atomic<int> left{4};
  GoalRequest request;
  request.twist = [&]() -> std::optional<Twist> {
    if (player_.begun >= left) return std::nullopt;
    return Twist{0.1, 0.0, 0.1};
  };
  const WalkReport report = walk(request);
  EXPECT_EQ(report.code, GoalCode::SUCCEEDED) << report.message;
  EXPECT_EQ(player_.begun, 4);
  // Ahead and to the left, as the velocity says.
  EXPECT_GT(poses_.latest().pose->x_m, 0.1);
  EXPECT_GT(poses_.latest().pose->yaw_rad, 0.2);
}

TEST_F(WalkerTest, AVelocityOfZeroBreaksOffAndANewerGoalTakesOver) {
  std::atomic<bool> moves{true};
  GoalRequest request;
  request.twist = [&] { return moves ? std::optional<Twist>(Twist{0.1, 0.0, 0.0}) : std::nullopt; };
  player_.held = true;
  Client client;
  submit(client, request);
  while (player_.begun == 0) std::this_thread::yield();
  moves = false;
  EXPECT_EQ(client.waitForEnd().code, GoalCode::SUCCEEDED);
  EXPECT_EQ(distance(*poses_.latest().pose, Pose2()), 0.0);
  player_.held = false;
  moves = true;
  Client overtaken;
  submit(overtaken, request);
  overtaken.waitForAcceptance();
  EXPECT_EQ(walk(goalAt(0.5, 0.2, 0.5)).code, GoalCode::SUCCEEDED);
  EXPECT_EQ(overtaken.waitForEnd().code, GoalCode::PREEMPTED);
}

// A planner that has just started.
TEST_F(WalkerTest, WaitsForTheRepertoireRightAfterItsStartAndNotLater) {
  RepertoireInUse none(PlannerOptions(), "", [] { return std::vector<std::string>(); });
  Walker walker({options_, clock_, poses_, none, player_, watcher_});
  clock_.on_step = [&] {
    if (!none.planner() && clock_.steadyNow_ns() > 2 * kSecond_ns) none.take(arcMessage(), "/s");
  };
  Client early;
  walker.submit(goalAt(0.5, 0.0, 0.0), early.listener());
  EXPECT_EQ(early.waitForEnd().code, GoalCode::SUCCEEDED);
  clock_.on_step = nullptr;
  RepertoireInUse still_none(PlannerOptions(), "", [] { return std::vector<std::string>(); });
  Walker other({options_, clock_, poses_, still_none, player_, watcher_});
  Client in_vain;
  other.submit(goalAt(0.5, 0.0, 0.0), in_vain.listener());
  EXPECT_EQ(in_vain.waitForEnd().code, GoalCode::NO_REPERTOIRE);
}

}  // namespace
}  // namespace hexapod
