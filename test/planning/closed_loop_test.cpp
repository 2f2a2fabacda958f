#include <gtest/gtest.h>

#include <memory>

#include "arc_repertoire.h"
#include "planning/adaptive_planner.h"
#include "planning/deviation.h"
#include "random_goal.h"

namespace hexapod {
namespace {

/// How the robot of these tests differs from its repertoire.
struct World {
  double noise_m = kSpread_m / std::sqrt(2.0);  ///< per axis
  double noise_rad = kSpread_rad;
  Deviation deviation;
};

struct Tally {
  int walks = 0;
  int arrived = 0;
  int behaviours = 0;

  double meanBehaviours() const { return static_cast<double>(behaviours) / walks; }
};

/// Walks to random goals within 1.5 m, planning anew after each behaviour, as the planner node
/// does.
class ClosedLoop : public testing::Test {
 protected:
  Tally walk(const World& world, int walks, bool learn_deviation) {
    Tally tally;
    for (; tally.walks < walks; ++tally.walks) {
      const PlanRequest request = requestTo(randomPose(random_, 1.5));
      const int behaviours = behavioursTo(request, world, learn_deviation);
      if (behaviours <= kMostBehaviours) ++tally.arrived;
      tally.behaviours += behaviours;
    }
    return tally;
  }

 private:
  static constexpr int kMostBehaviours = 40;

  int behavioursTo(PlanRequest request, const World& world, bool learn_deviation) {
    AdaptivePlanner planner(like_,
                            learn_deviation ? std::make_shared<DeviationForesight>() : nullptr);
    for (int count = 0; count <= kMostBehaviours; ++count) {
      const PlanResult plan = planner.plan(request);
      if (plan.code == PlanCode::kAlreadyThere) return count;
      if (plan.code != PlanCode::kFound) break;
      const std::size_t entry = plan.steps.front().entry;
      const Pose2 before = request.world_from_start;
      request.world_from_start =
          before * executed(repertoire_.entries[entry].expectedPose(), world);
      planner.observe(entry, before, request.world_from_start);
    }
    return kMostBehaviours + 1;
  }

  Pose2 executed(const Pose2& expected, const World& world) {
    Pose2 end = world.deviation.apply(expected);
    end.x_m += world.noise_m * normal(random_);
    end.y_m += world.noise_m * normal(random_);
    end.yaw_rad = wrapAngle(end.yaw_rad + world.noise_rad * normal(random_));
    return end;
  }

  Random random_{11};
  static PlannerOptions quicklyBuilt() {
    PlannerOptions options;
    options.max_pairs = 40000;
    return options;
  }

  const Repertoire repertoire_ = arcRepertoire(400, 1);
  const AdaptivePlanner like_{repertoire_, quicklyBuilt(), nullptr};
};

TEST_F(ClosedLoop, ArrivesWithTheNoiseOfTheRepertoire) {
  const Tally tally = walk(World{}, 300, false);
  RecordProperty("mean_behaviours", std::to_string(tally.meanBehaviours()));
  EXPECT_GE(tally.arrived, 297);
  EXPECT_LT(tally.meanBehaviours(), 3.0);
}

TEST_F(ClosedLoop, ArrivesWithMoreNoiseThanTheRepertoireSays) {
  World world;
  world.noise_m = 0.01;
  world.noise_rad = 0.026;
  const Tally tally = walk(world, 300, true);
  EXPECT_GE(tally.arrived, 297);
  EXPECT_LT(tally.meanBehaviours(), 3.5);
}

TEST_F(ClosedLoop, ArrivesWhenBehavioursTurnTenDegreesTooMuchWithoutLearningIt) {
  World world;
  world.deviation.turn_rad = M_PI / 18.0;
  EXPECT_GE(walk(world, 100, false).arrived, 99);
}

TEST_F(ClosedLoop, ArrivesWhenBehavioursAreOffByThirtyPercentAndTenDegrees) {
  const double off_rad = M_PI / 18.0;
  for (const double scale : {0.7, 1.3}) {
    for (const Deviation& deviation :
         {Deviation{scale, 0.0, scale, 0.0}, Deviation{scale, 0.0, scale, off_rad},
          Deviation{scale, -off_rad, scale, 0.0}}) {
      World world;
      world.deviation = deviation;
      const Tally tally = walk(world, 25, true);
      EXPECT_EQ(tally.arrived, 25);
      EXPECT_LT(tally.meanBehaviours(), 6.0);
    }
  }
}

}  // namespace
}  // namespace hexapod
