#include <gtest/gtest.h>

#include <cmath>

#include "gait/symmetry.h"
#include "simulation/reduced/reduced_world.h"
#include "simulation/rollout.h"
#include "test_robots.h"

namespace hexapod {
namespace {

struct Played {
  Verdict verdict;
  Pose2 end;  ///< not rounded, unlike an outcome's
};

Played playedFromStand(World& world, const Genome& genome) {
  const BehaviorOptions options;
  world.restart();
  const Behavior behavior(world.robot(), genome, options);
  const Verdict verdict = play(world, behavior, options.command_period_s).verdict;
  return {verdict, footprint(world.worldFromBase())};
}

TEST(Symmetry, OfTheHexapodIsExactInSimulation) {
  const RobotDescription robot = handMadeHexapod();
  const auto symmetries = symmetriesOf(robot);
  ASSERT_EQ(symmetries.size(), 3u);
  ReducedWorld world(robot, {});
  for (const Genome& genome : randomGenomes(robot, 25, 11)) {
    const Played played = playedFromStand(world, genome);
    for (const Symmetry& symmetry : symmetries) {
      const Played image = playedFromStand(world, symmetry.image(genome));
      ASSERT_EQ(image.verdict, played.verdict) << toString(genome);
      if (played.verdict != Verdict::kWalked) continue;
      const Pose2 expected = symmetry.image(played.end);
      EXPECT_LE(distance(image.end, expected), 1e-6) << symmetry.name() << toString(genome);
      EXPECT_LE(headingDistance(image.end, expected), 1e-6) << symmetry.name() << toString(genome);
    }
  }
}

TEST(Symmetry, IsNotClaimedForAHexapodWithOneShortLeg) {
  RobotDescription robot = handMadeHexapod();
  robot.legs[0].segments[2].body.shapes[0].length_m -= 0.002;
  EXPECT_TRUE(symmetriesOf(robot).empty());
}

}  // namespace
}  // namespace hexapod
