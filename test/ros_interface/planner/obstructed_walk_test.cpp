#include <gtest/gtest.h>

#include <memory>

#include "planning/arc_repertoire.h"
#include "planning/made_map.h"
#include "repertoire/import_repertoire.h"
#include "ros_interface/fake_clock.h"
#include "ros_interface/planner/fakes.h"
#include "ros_interface/planner/walker.h"

namespace hexapod {
namespace {

using Shared = std::shared_ptr<const Obstacles>;

/// Walls of 10 cm at a distance from the origin, closed or with a gap of 1.2 m to the left.
Shared wallsAround(double distance_m, bool gap) {
  return obstaclesOf([=](double x_m, double y_m) {
    const double out_m = std::max(std::abs(x_m), std::abs(y_m));
    return out_m > distance_m && out_m < distance_m + 0.1 &&
           !(gap && x_m < 0.0 && std::abs(y_m) < 0.6);
  });
}

// Walks with a made-up executor, pose, clock and map: no master, no waiting.
class ObstructedWalk : public testing::Test {
 protected:
  ObstructedWalk() {
    Repertoire repertoire = arcRepertoire(300, 1);
    repertoire.run_id = "run";
    repertoire.behavior_duration_s = 3.9;
    repertoire_.take(toMsg(repertoire, ros::Time(1.0)), "/server");
  }

  void show(Shared obstacles) {
    const std::lock_guard<std::mutex> lock(mutex_);
    obstacles_ = std::move(obstacles);
  }

  std::unique_ptr<Walker> walker() {
    return std::make_unique<Walker>(
        Walker::Means{options_, clock_, poses_, repertoire_, player_, watcher_, [this] {
                        const std::lock_guard<std::mutex> lock(mutex_);
                        return obstacles_;
                      }});
  }

  WalkReport walk(const GoalRequest& request) {
    Client client;
    const auto walking = walker();
    walking->submit(request, client.listener());
    return client.waitForEnd();
  }

  void waitForBehaviour(int number) {
    while (player_.begun < number) std::this_thread::yield();
  }

  PlannerNodeOptions options_;
  FakeClock clock_;
  FakePoseSource poses_;
  FakePlayer player_{poses_};
  FakeWatcher watcher_;
  RepertoireInUse repertoire_{PlannerOptions(), "", [] { return std::vector<std::string>(); }};
  std::mutex mutex_;
  Shared obstacles_;
};

TEST_F(ObstructedWalk, GoesAroundWhatTheMapShows) {
  show(wallsAround(2.0, true));
  const WalkReport report = walk(goalAt(3.0, 0.0, 0.0));
  EXPECT_EQ(report.code, GoalCode::SUCCEEDED) << report.message;
  double leftmost_m = 0.0;
  for (const auto& pose : report.plan.poses) {
    leftmost_m = std::min(leftmost_m, pose.pose.position.x);
    EXPECT_TRUE(obstacles_->clearance_m({pose.pose.position.x, pose.pose.position.y, 0.0}) > -0.03);
  }
  EXPECT_LT(leftmost_m, -2.0) << "not out by the gap";
  EXPECT_GE(report.plan_summary.clearance_m, 0.0);
  EXPECT_GE(report.tally.clearance_m, 0.0);
  EXPECT_LT(report.tally.clearance_m, 0.3);
}

TEST_F(ObstructedWalk, RefusesGoalsWithTheirReason) {
  show(wallsAround(2.0, false));
  for (const auto& [goal_x_m, code] :
       {std::pair{3.0, GoalCode::BLOCKED}, std::pair{2.05, GoalCode::GOAL_OCCUPIED}}) {
    const WalkReport refusal = walk(goalAt(goal_x_m, 0.0, 0.0));
    EXPECT_EQ(refusal.code, code);
    EXPECT_EQ(refusal.nearest_pose.header.frame_id, "odom");
    EXPECT_NEAR(refusal.nearest_pose.pose.position.x, 2.0 - 0.33, 0.1);
  }
  poses_.set({Pose2{2.05, 0.0, 0.0}, ""});
  const WalkReport refusal = walk(goalAt(0.0, 0.0, 0.0));
  EXPECT_EQ(refusal.code, GoalCode::START_OCCUPIED);
  EXPECT_EQ(refusal.nearest_pose.header.frame_id, "") << "none was looked for";
  EXPECT_EQ(player_.begun, 0);
}

TEST_F(ObstructedWalk, RefusesGoalsWhileItIsNotKnownWhereTheMapLies) {
  Walker walking({options_, clock_, poses_, repertoire_, player_, watcher_, [] { return Shared(); },
                  [] { return std::string("The map lies nowhere."); }});
  Client client;
  walking.submit(goalAt(1.0, 0.3, 0.0), client.listener());
  while (client.ends() == 0) clock_.pass(kSecond_ns / 10);
  EXPECT_EQ(client.waitForEnd().code, GoalCode::UNKNOWN_FRAME);
  EXPECT_EQ(client.waitForEnd().message, "The map lies nowhere.");
  EXPECT_EQ(player_.begun, 0);
}

TEST_F(ObstructedWalk, WalksToTheNearestFreePoseByOptionAndDoesNotCallThatSuccess) {
  options_.goal_policy = "nearest";
  show(wallsAround(2.0, false));
  const WalkReport report = walk(goalAt(2.05, 0.0, 0.0));
  EXPECT_EQ(report.code, GoalCode::GOAL_OCCUPIED);
  EXPECT_NE(report.message.find("nearest free pose"), std::string::npos) << report.message;
  EXPECT_NEAR(poses_.latest().pose->x_m, 2.0 - 0.33, 0.15);
}

TEST_F(ObstructedWalk, BreaksOffABehaviourThatWouldTouchWhatANewMapShowsAndGoesAnotherWay) {
  player_.held = true;
  Client client;
  const auto walking = walker();
  walking->submit(goalAt(3.0, 0.0, 0.0), client.listener());
  waitForBehaviour(1);
  show(obstaclesOf(
      [](double x_m, double y_m) { return std::abs(x_m - 0.5) < 0.1 && std::abs(y_m) < 0.8; }));
  waitForBehaviour(2);  // nobody released the first
  player_.held = false;
  const WalkReport report = client.waitForEnd();
  EXPECT_EQ(report.code, GoalCode::SUCCEEDED) << report.message;
}

TEST_F(ObstructedWalk, FinishesABehaviourThatANewMapLeavesAlone) {
  player_.held = true;
  Client client;
  const auto walking = walker();
  walking->submit(goalAt(1.2, 0.0, 0.0), client.listener());
  waitForBehaviour(1);
  show(wallsAround(2.0, false));
  // Asked for by the behaviour, and again: it has seen the new map and goes on.
  while (obstacles_.use_count() < 2) std::this_thread::yield();
  player_.held = false;
  const WalkReport report = client.waitForEnd();
  EXPECT_EQ(report.code, GoalCode::SUCCEEDED) << report.message;
  EXPECT_EQ(player_.begun, static_cast<int>(report.steps));
  EXPECT_EQ(watcher_.steps, static_cast<int>(report.steps)) << "one was broken off";
}

TEST_F(ObstructedWalk, StandsWhileEveryWayIsClosedAndArrivesWhenOneOpens) {
  options_.blocked_retry_s = 60.0;
  player_.held = true;
  Client client;
  const auto walking = walker();
  walking->submit(goalAt(3.0, 0.0, 0.0), client.listener());
  waitForBehaviour(1);
  clock_.on_step = [this, until_ns = clock_.steadyNow_ns() + 20 * kSecond_ns] {
    if (clock_.steadyNow_ns() > until_ns) show(wallsAround(2.0, true));
  };
  show(wallsAround(2.0, false));
  player_.held = false;
  const WalkReport report = client.waitForEnd();
  EXPECT_EQ(report.code, GoalCode::SUCCEEDED) << report.message;
  EXPECT_GE(clock_.steadyNow_ns(), 20 * kSecond_ns);
}

TEST_F(ObstructedWalk, EndsBlockedWhenNoWayOpensInTime) {
  options_.blocked_retry_s = 10.0;
  player_.held = true;
  Client client;
  const auto walking = walker();
  walking->submit(goalAt(3.0, 0.0, 0.0), client.listener());
  waitForBehaviour(1);
  show(wallsAround(2.0, false));
  player_.held = false;
  EXPECT_EQ(client.waitForEnd().code, GoalCode::BLOCKED);
}

/// A velocity that a test changes.
class HeldTwist {
 public:
  explicit HeldTwist(const Twist& twist) : twist_(twist) {}

  GoalRequest request() {
    GoalRequest request;
    request.twist = [this] {
      const std::lock_guard<std::mutex> lock(mutex_);
      return twist_;
    };
    return request;
  }
  void become(const std::optional<Twist>& twist) {
    const std::lock_guard<std::mutex> lock(mutex_);
    twist_ = twist;
  }

 private:
  std::mutex mutex_;
  std::optional<Twist> twist_;
};

class VelocityAmongObstacles : public ObstructedWalk {
 protected:
  void waitUntilItStands(int times = 1) {
    while (watcher_.standing < times) std::this_thread::yield();
  }
  Pose2 robot() const { return *poses_.latest().pose; }

  HeldTwist twist_{{0.2, 0.0, 0.0}};
  Client client_;
};

TEST_F(VelocityAmongObstacles, IsWalkedUpToThemWhichIsToldOnceAndOnWhenTheyAreGone) {
  const auto walls = wallsAround(2.0, false);
  show(walls);
  const auto walking = walker();
  walking->submit(twist_.request(), client_.listener());
  waitUntilItStands();
  EXPECT_GE(walls->clearance_m(robot()), 0.0);
  EXPECT_GT(robot().x_m, 1.2) << "it stopped long before";
  const std::int64_t then_ns = clock_.steadyNow_ns();
  while (clock_.steadyNow_ns() < then_ns + 10 * kSecond_ns) std::this_thread::yield();
  EXPECT_EQ(watcher_.standing, 1);
  show(nullptr);
  while (robot().x_m < 2.5) std::this_thread::yield();
  twist_.become(std::nullopt);
  const WalkReport report = client_.waitForEnd();
  EXPECT_EQ(report.code, GoalCode::SUCCEEDED);
  EXPECT_GT(report.tally.distance_m, 2.4);
  EXPECT_EQ(report.tally.measured, 0u);
  EXPECT_EQ(watcher_.standing, 1);
}

TEST_F(VelocityAmongObstacles, LeadsAwayFromThemAtOnce) {
  const auto walls = wallsAround(2.0, false);
  show(walls);
  const auto walking = walker();
  walking->submit(twist_.request(), client_.listener());
  waitUntilItStands();
  const double stood_x_m = robot().x_m;
  twist_.become(Twist{-0.1, 0.0, 0.0});
  while (robot().x_m > stood_x_m - 0.5) std::this_thread::yield();
  EXPECT_EQ(client_.ends(), 0u);
  walking->cancelAll();
  EXPECT_EQ(client_.waitForEnd().code, GoalCode::PREEMPTED);
}

TEST_F(VelocityAmongObstacles, IsBrokenOffWhenANewMapShowsOneInTheWay) {
  player_.held = true;
  const auto walking = walker();
  walking->submit(twist_.request(), client_.listener());
  waitForBehaviour(1);
  show(obstaclesOf([](double x_m, double y_m) { return x_m > 0.35 && std::abs(y_m) < 3.0; }));
  waitUntilItStands();  // nobody released the behaviour
  EXPECT_EQ(player_.begun, 1);
  walking->cancelAll();
  EXPECT_EQ(client_.waitForEnd().code, GoalCode::PREEMPTED);
}

TEST_F(VelocityAmongObstacles, EndsWhenThePoseIsLostAndNotWithoutAMap) {
  poses_.set({std::nullopt, "The robot's pose is lost."});
  show(wallsAround(2.0, false));
  const auto walking = walker();
  walking->submit(twist_.request(), client_.listener());
  EXPECT_EQ(client_.waitForEnd().code, GoalCode::POSE_LOST);
  EXPECT_EQ(player_.begun, 0);
  show(nullptr);
  player_.held = true;
  Client blind;
  walking->submit(twist_.request(), blind.listener());
  waitForBehaviour(1);
  walking->cancelAll();
  EXPECT_EQ(blind.waitForEnd().code, GoalCode::PREEMPTED);
}

TEST_F(ObstructedWalk, PlansWithAnImportedRepertoireButDoesNotWalkWithIt) {
  Repertoire imported = arcRepertoire(300, 1);
  imported.robot_id = kImported;
  for (Entry& entry : imported.entries) entry.genome.clear();
  RepertoireInUse in_use(PlannerOptions(), "robot", [] { return std::vector<std::string>(); });
  ASSERT_TRUE(in_use.take(toMsg(imported, ros::Time(1.0)), "/server").in_use);
  Walker walking({options_, clock_, poses_, in_use, player_, watcher_});
  Client walks;
  walking.submit(goalAt(1.0, 0.3, 0.0), walks.listener());
  const WalkReport refused = walks.waitForEnd();
  EXPECT_EQ(refused.code, GoalCode::NO_REPERTOIRE);
  EXPECT_NE(refused.message.find("imported"), std::string::npos) << refused.message;
  Client plans;
  GoalRequest request = goalAt(1.0, 0.3, 0.0);
  request.plan_only = true;
  walking.submit(request, plans.listener());
  EXPECT_EQ(plans.waitForEnd().code, GoalCode::SUCCEEDED);
  EXPECT_EQ(player_.begun, 0);
}

}  // namespace
}  // namespace hexapod
