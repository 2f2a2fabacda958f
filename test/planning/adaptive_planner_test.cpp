#include "planning/adaptive_planner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "arc_repertoire.h"
#include "common/text.h"
#include "planning/walk.h"
#include "random_goal.h"

namespace hexapod {
namespace {

// A floor on which everything slides the same way.
class Sliding : public Foresight {
 public:
  explicit Sliding(const Eigen::Vector2d& drift_m) : drift_m_(drift_m) {}
  void observe(const WalkedStep&) override {}
  std::shared_ptr<const Repertoire> expected(
      const std::shared_ptr<const Repertoire>& repertoire) override {
    return repertoire;
  }
  Eigen::Vector2d drift_m() const override { return drift_m_; }

 private:
  Eigen::Vector2d drift_m_;
};

// A robot whose later behaviours in a chain lead elsewhere than the first.
class Following : public Foresight {
 public:
  void observe(const WalkedStep&) override {}
  std::shared_ptr<const Repertoire> expected(
      const std::shared_ptr<const Repertoire>& repertoire) override {
    return repertoire;
  }
  std::vector<Pose2> follow(const Pose2& world_from_start,
                            const std::vector<Entry>& chain) const override {
    std::vector<Pose2> poses;
    Pose2 pose = world_from_start;
    for (const Entry& entry : chain) {
      pose = pose * entry.expectedPose();
      if (!poses.empty()) pose = pose * Pose2{0.05, -0.03, 0.1};
      poses.push_back(pose);
    }
    return poses;
  }
};

// Leaves out all entries that lead backwards once anything was walked.
class OnlyForward : public Foresight {
 public:
  void observe(const WalkedStep& step) override {
    seen_ = step;
    walked_ = true;
  }
  std::shared_ptr<const Repertoire> expected(
      const std::shared_ptr<const Repertoire>& repertoire) override {
    if (!walked_) return repertoire;
    if (made_) return made_;
    auto made = std::make_shared<Repertoire>(*repertoire);
    for (Entry& entry : made->entries) {
      if (entry.expectedPose().x_m < 0.0) entry.execution->falls = 1;
    }
    return made_ = made;
  }
  WalkedStep seen_;

 private:
  bool walked_ = false;
  std::shared_ptr<const Repertoire> made_;
};

// Expects nothing to walk once anything was walked.
class Hopeless : public Foresight {
 public:
  void observe(const WalkedStep&) override { walked_ = true; }
  std::shared_ptr<const Repertoire> expected(
      const std::shared_ptr<const Repertoire>& repertoire) override {
    if (!walked_) return repertoire;
    auto made = std::make_shared<Repertoire>(*repertoire);
    for (Entry& entry : made->entries) entry.execution->falls = 1;
    return made;
  }

 private:
  bool walked_ = false;
};

TEST(AdaptivePlanner, TellsThatTheBelievedBodyLeavesNothingAndDoesNotTakeItForAJump) {
  const Repertoire repertoire = arcRepertoire(300, 1);
  const auto planner =
      std::make_shared<AdaptivePlanner>(repertoire, PlannerOptions(), std::make_shared<Hopeless>());
  EXPECT_GT(planner->reach_m(), 0.3);
  Walk walk(planner, {3.0, 0.0, 0.0}, {0.05, 0.1});
  const Walk::Decision first = walk.decide(Pose2());
  ASSERT_EQ(first.state, WalkState::kStep);
  const Walk::Decision second = walk.decide(first.step->world_from_end);
  EXPECT_EQ(second.state, WalkState::kNoPlan) << second.message;
  EXPECT_EQ(second.plan.code, PlanCode::kNoRepertoire);
  EXPECT_NE(second.message.find("~reset_belief"), std::string::npos) << second.message;
}

TEST(AdaptivePlanner, SeeksGoalsAgainstTheDrift) {
  const Repertoire repertoire = arcRepertoire(300, 1);
  const Eigen::Vector2d drift_m(0.03, -0.04);
  const AdaptivePlanner planner(repertoire, PlannerOptions(), std::make_shared<Sliding>(drift_m));
  Random random(5);
  int longest = 0;
  for (int i = 0; i < 30; ++i) {
    PlanRequest request = requestTo(randomPose(random, 1.5));
    request.world_from_start = randomPose(random, 1.0);
    const PlanResult plan = planner.plan(request);
    ASSERT_EQ(plan.code, PlanCode::kFound) << plan.message;
    // Walked on the sliding floor the plan ends where it says, and in the goal.
    Pose2 pose = request.world_from_start;
    for (const PlannedStep& step : plan.steps) {
      pose = pose * repertoire.entries[step.entry].expectedPose();
      pose.x_m += drift_m.x();
      pose.y_m += drift_m.y();
      EXPECT_LT(distance(pose, step.world_from_end), 1e-9);
    }
    EXPECT_LT(distance(pose, plan.world_from_end), 1e-9);
    EXPECT_LE(distance(pose, request.world_from_goal), request.tolerance.xy_m);
    longest = std::max(longest, static_cast<int>(plan.steps.size()));
  }
  EXPECT_GE(longest, 3);
}

TEST(AdaptivePlanner, FinishesAChainThatWasBegunOnASlidingFloor) {
  const Repertoire repertoire = arcRepertoire(300, 1);
  const Eigen::Vector2d drift_m(-0.06, 0.01);
  const AdaptivePlanner planner(repertoire, PlannerOptions(), std::make_shared<Sliding>(drift_m));
  Random random(6);
  for (int i = 0; i < 20; ++i) {
    PlanRequest request = requestTo(randomPose(random, 1.5));
    const std::size_t promised = planner.plan(request).steps.size();
    std::size_t walked = 0;
    Pose2& pose = request.world_from_start;
    while (distance(pose, request.world_from_goal) > request.tolerance.xy_m ||
           headingDistance(pose, request.world_from_goal) > request.tolerance.yaw_rad) {
      const PlanResult plan = planner.plan(request);
      ASSERT_EQ(plan.code, PlanCode::kFound) << plan.message;
      pose = plan.steps.front().world_from_end;
      ASSERT_LE(++walked, promised + 1);
    }
  }
}

TEST(AdaptivePlanner, PlansWithWhereChainsReallyLead) {
  const Repertoire repertoire = arcRepertoire(300, 1);
  const AdaptivePlanner planner(repertoire, PlannerOptions(), std::make_shared<Following>());
  Random random(7);
  int arriving = 0, longer = 0;
  for (int i = 0; i < 30; ++i) {
    PlanRequest request = requestTo(randomPose(random, 1.5));
    request.world_from_start = randomPose(random, 1.0);
    const PlanResult plan = planner.plan(request);
    ASSERT_EQ(plan.code, PlanCode::kFound) << plan.message;
    std::vector<Entry> chain;
    for (const PlannedStep& step : plan.steps) chain.push_back(repertoire.entries[step.entry]);
    const std::vector<Pose2> poses = Following().follow(request.world_from_start, chain);
    for (std::size_t k = 0; k < poses.size(); ++k) {
      EXPECT_LT(distance(poses[k], plan.steps[k].world_from_end), 1e-9);
    }
    EXPECT_LT(distance(poses.back(), plan.world_from_end), 1e-9);
    EXPECT_NEAR(plan.distance_m, distance(poses.back(), request.world_from_goal), 1e-9);
    EXPECT_LT(distance(plan.world_from_target, request.world_from_goal), 1e-9);
    const std::string told = numberText(plan.distance_m, 3) + " m and ";
    EXPECT_NE(plan.message.find("predicted to end " + told), std::string::npos) << plan.message;
    EXPECT_LE(plan.at_least_steps, plan.steps.size());
    EXPECT_EQ(plan.message.find("the nearest free pose"), std::string::npos) << plan.message;
    arriving +=
        plan.distance_m <= request.tolerance.xy_m && plan.heading_rad <= request.tolerance.yaw_rad;
    longer += plan.steps.size() > 1;
  }
  EXPECT_GE(arriving, 29);
  EXPECT_GE(longer, 20);
}

// A robot of which nobody knows where it ends.
class Stray : public Following {
 public:
  std::vector<Pose2> follow(const Pose2& world_from_start,
                            const std::vector<Entry>& chain) const override {
    std::vector<Pose2> poses = Following::follow(world_from_start, chain);
    direction_rad_ += 2.0;
    poses.back() =
        poses.back() * Pose2{0.2 * std::cos(direction_rad_), 0.2 * std::sin(direction_rad_), 0.0};
    return poses;
  }

 private:
  mutable double direction_rad_ = 0.0;
};

TEST(AdaptivePlanner, SaysWhereNoChainThatItFollowedEndsWithinTheTolerance) {
  const Repertoire repertoire = arcRepertoire(300, 1);
  const AdaptivePlanner planner(repertoire, PlannerOptions(), std::make_shared<Stray>());
  const PlanRequest request = requestTo({0.9, 0.4, 0.5});
  const PlanResult plan = planner.plan(request);
  ASSERT_EQ(plan.code, PlanCode::kFound) << plan.message;
  EXPECT_GT(plan.shareMissed(request.tolerance), 1.0);
  EXPECT_NE(plan.message.find("from the goal, outside of the tolerance"), std::string::npos)
      << plan.message;
  EXPECT_EQ(plan.message.find("no plan has fewer"), std::string::npos) << plan.message;
}

TEST(AdaptivePlanner, PlansWithWhatIsExpectedAfterAnObservation) {
  const Repertoire repertoire = arcRepertoire(300, 1);
  const auto foresight = std::make_shared<OnlyForward>();
  AdaptivePlanner planner(repertoire, PlannerOptions(), foresight);
  const auto before = planner.planner();
  planner.observe(7, Pose2{1.0, 0.0, 0.0}, Pose2{1.5, 0.0, 0.0}, {{-0.1, 0.2}});
  EXPECT_EQ(foresight->seen_.entry.id, repertoire.entries[7].id);
  EXPECT_EQ(foresight->seen_.joints.size(), 1u);
  EXPECT_LT(planner.planner()->usableEntries(), before->usableEntries());
  // Nothing new is expected: the planner stays.
  const auto after = planner.planner();
  planner.observe(8, Pose2(), Pose2{0.5, 0.0, 0.0});
  EXPECT_EQ(planner.planner(), after);
}

TEST(AdaptivePlanner, IsToldByAWalkHowFarTheJointsMoved) {
  const auto foresight = std::make_shared<OnlyForward>();
  const auto planner =
      std::make_shared<AdaptivePlanner>(arcRepertoire(300, 1), PlannerOptions(), foresight);
  Walk walk(planner, {1.5, 0.0, 0.0}, GoalTolerance());
  const auto first = walk.decide(Pose2());
  walk.noteJoints({{-0.1, 0.2}});
  const Pose2 there = first.step->world_from_end;
  ASSERT_EQ(walk.decide(there).state, WalkState::kStep);
  EXPECT_EQ(foresight->seen_.joints.size(), 1u);
  walk.decide(there);
  EXPECT_TRUE(foresight->seen_.joints.empty()) << "those of the behaviour before";
}

// Asks for another first behaviour than one.
class Wary : public Foresight {
 public:
  void observe(const WalkedStep&) override { is_wary_ = false; }
  std::shared_ptr<const Repertoire> expected(
      const std::shared_ptr<const Repertoire>& repertoire) override {
    return repertoire;
  }
  std::shared_ptr<const std::vector<double>> caution(
      const std::shared_ptr<const Repertoire>& repertoire) const override {
    if (!is_wary_) return nullptr;
    auto prices = std::make_shared<std::vector<double>>(repertoire->entries.size(), 0.0);
    (*prices)[of] = 0.9;
    return prices;
  }
  std::size_t of = 0;

 private:
  bool is_wary_ = true;
};

TEST(AdaptivePlanner, AvoidsAsTheFirstBehaviourWhatItsForesightIsWaryOf) {
  const Repertoire repertoire = arcRepertoire(600, 1);
  const PlanRequest request = requestTo({0.9, 0.3, 0.4});
  const PlanResult usual = AdaptivePlanner(repertoire, {}, nullptr).plan(request);
  ASSERT_GT(usual.steps.size(), 1u);
  const auto wary = std::make_shared<Wary>();
  wary->of = usual.steps.front().entry;
  AdaptivePlanner planner(repertoire, {}, wary);
  const PlanResult careful = planner.plan(request);
  ASSERT_TRUE(careful.success());
  EXPECT_NE(careful.steps.front().entry, wary->of);
  EXPECT_EQ(careful.steps.size(), usual.steps.size()) << "others are as short";
  planner.observe(0, {}, {});
  EXPECT_EQ(planner.plan(request).steps.front().entry, wary->of);
}

TEST(AdaptivePlanner, WalksWhatItIsWaryOfWhereAllElseTakesAnotherBehaviour) {
  Repertoire repertoire = arcRepertoire(600, 1);
  const Pose2 end = repertoire.entries[3].expectedPose();
  const auto wary = std::make_shared<Wary>();
  wary->of = 3;
  PlanRequest request = requestTo(end);
  request.tolerance = {0.005, 0.02};
  const PlanResult plan = AdaptivePlanner(repertoire, {}, wary).plan(request);
  ASSERT_EQ(plan.steps.size(), 1u) << plan.message;
  EXPECT_EQ(plan.steps.front().entry, 3u);
}

TEST(AdaptivePlanner, TakesTheRepertoireAtItsWordWithoutAForesight) {
  AdaptivePlanner planner(arcRepertoire(300, 1), PlannerOptions(), nullptr);
  const auto before = planner.planner();
  for (std::size_t i = 0; i < 20; ++i) planner.observe(i, Pose2(), Pose2{0.1, 0.4, 1.0});
  EXPECT_EQ(planner.planner(), before);
}

}  // namespace
}  // namespace hexapod
