#include "simulation/reduced/reduced_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "common/random.h"
#include "gait/behavior.h"
#include "simulation/ode/ode_world.h"
#include "simulation/standing_state.h"
#include "test_robots.h"

namespace hexapod {
namespace {

// Largest difference of positions and quaternions, and of velocities and rates.
struct Difference {
  double pose = 0.0;
  double velocity = 0.0;
};

Difference difference(const WorldState& a, const WorldState& b, std::size_t bodies) {
  Difference largest;
  for (std::size_t i = 0; i < bodies * kStateValuesPerBody; ++i) {
    const bool is_velocity = i % kStateValuesPerBody >= kVelocity;
    double& of_kind = is_velocity ? largest.velocity : largest.pose;
    of_kind = std::max(of_kind, std::abs(a.values[i] - b.values[i]));
  }
  return largest;
}

// Follows ODE with targets drawn anew every other step, out to `reach_rad`, and takes each single
// step in the reduced engine, too, from ODE's own state.
Difference largestStepDifference(const RobotDescription& robot, const Physics& physics,
                                 double reach_rad, int steps) {
  OdeWorld ode(robot, physics);
  ReducedWorld reduced(robot, physics);
  Random random(3);
  std::vector<double> targets(robot.jointCount());
  Difference largest;
  for (int i = 0; i < steps; ++i) {
    if (i % 2 == 0) {
      for (double& target : targets) target = random.uniform(-reach_rad, reach_rad);
    }
    ode.setTargets(targets);
    reduced.restore(ode.state());
    EXPECT_EQ(ode.step(), reduced.step());
    const Difference now = difference(ode.state(), reduced.state(), robot.jointCount() + 1);
    largest.pose = std::max(largest.pose, now.pose);
    largest.velocity = std::max(largest.velocity, now.velocity);
  }
  return largest;
}

void expectStepsAsOde(const RobotDescription& robot, const Physics& physics, double reach_rad) {
  const Difference largest = largestStepDifference(robot, physics, reach_rad, 200);
  EXPECT_LT(largest.velocity, 1e-6);
  EXPECT_LT(largest.pose, 1e-8);
}

TEST(ReducedWorld, StepsAsOdeFromTheSameState) {
  expectStepsAsOde(handMadeHexapod(), Physics(), 0.6);
}

TEST(ReducedWorld, DiffersFromOdeByItsCompliantJointsOnly) {
  RobotDescription robot = handMadeHexapod();
  robot.contact.joint_cfm = 1e-15;
  const Difference largest = largestStepDifference(robot, Physics(), 0.6, 100);
  EXPECT_LT(largest.velocity, 1e-10);
  EXPECT_LT(largest.pose, 1e-12);
}

TEST(ReducedWorld, StepsAsOdeUnderOtherPhysics) {
  Physics physics;
  physics.step_s = 0.005;
  physics.gravity_m_per_s2 = 8.0;
  physics.friction_scale = 0.4;
  physics.mass_scale = 1.3;
  physics.servo_gain_scale = 1.5;
  physics.slope_x_rad = 0.1;
  physics.slope_y_rad = -0.15;
  expectStepsAsOde(handMadeHexapod(), physics, 0.6);
}

TEST(ReducedWorld, StepsAsOdeWhenMotorsGiveWay) {
  Physics physics;
  physics.torque_scale = 0.5;
  expectStepsAsOde(handMadeHexapod(), physics, 0.8);
}

TEST(ReducedWorld, StepsAsOdeWithoutFriction) {
  Physics physics;
  physics.friction_scale = 0.0;
  expectStepsAsOde(handMadeHexapod(), physics, 0.6);
}

TEST(ReducedWorld, StepsAsOdeAtTheStopsOfJoints) {
  RobotDescription robot = handMadeHexapod();
  for (Leg& leg : robot.legs) {
    for (Segment& segment : leg.segments) {
      segment.joint.lower_rad = -0.15;
      segment.joint.upper_rad = 0.1;
    }
  }
  expectStepsAsOde(robot, Physics(), 0.6);
}

TEST(ReducedWorld, StepsAsOdeForAFourLeggedRobotWithTwoJointsPerLegAndRoundFeet) {
  RobotDescription robot = handMadeHexapod();
  robot.legs.erase(robot.legs.begin() + 4);
  robot.legs.erase(robot.legs.begin() + 1);
  for (Leg& leg : robot.legs) {
    leg.segments.erase(leg.segments.begin());
    leg.segments[0].joint.parent_from_joint =
        handMadeHexapod().legs[0].segments[0].joint.parent_from_joint;
    leg.segments[1].body.shapes[0].kind = Shape::Kind::kSphere;
    leg.segments[1].body.shapes[0].body_from_shape.translation().z() = -0.12;
    leg.segments[1].body.inertia_kg_m2(0, 1) = 1e-5;
    leg.segments[1].body.inertia_kg_m2(1, 0) = 1e-5;
  }
  const RobotDescription whole = handMadeHexapod();
  const std::size_t hips[] = {0, 2, 3, 5};
  for (std::size_t i = 0; i < 4; ++i) {
    robot.legs[i].segments[0].joint.parent_from_joint =
        whole.legs[hips[i]].segments[0].joint.parent_from_joint;
  }
  expectStepsAsOde(robot, Physics(), 0.3);
}

TEST(ReducedWorld, StepsAsOdeForLegsOfOneTwoAndThreeJoints) {
  RobotDescription robot = handMadeHexapod();
  robot.legs[1].segments.resize(2);
  robot.legs[4].segments.resize(1);
  expectStepsAsOde(robot, Physics(), 0.4);
}

TEST(ReducedWorld, StepsAsOdeForTenLegs) {
  RobotDescription robot = handMadeHexapod();
  for (const std::size_t outer : {0, 2, 3, 5}) {
    robot.legs.push_back(robot.legs[outer]);
    Eigen::Isometry3d& hip = robot.legs.back().segments[0].joint.parent_from_joint;
    // Half way to the middle leg.
    hip.translation().x() *= 0.5;
    hip.translation().y() *= 4.0 / 3.0;
  }
  expectStepsAsOde(robot, Physics(), 0.4);
}

TEST(ReducedWorld, StepsAsOdeForLegsOfBoxes) {
  RobotDescription robot = hexapodOfBoxes();
  robot.contact.joint_cfm = 1e-14;  // four contacts a foot pull harder at the joints
  expectStepsAsOde(robot, Physics(), 0.6);
}

TEST(ReducedWorld, RestsOnTheCornersOfOneSideOfABoxThatIsThinnerThanItSinksInAsInOde) {
  RobotDescription robot = hexapodOfBoxes();
  robot.contact.soft_cfm = 0.05;
  for (Leg& leg : robot.legs) {
    Shape foot;
    foot.kind = Shape::Kind::kBox;
    foot.size_m = {0.04, 0.03, 0.0005};
    foot.body_from_shape.translation().z() = -0.16;
    leg.segments[2].body.shapes.push_back(foot);
  }
  expectStepsAsOde(robot, Physics(), 0.3);
}

TEST(ReducedWorld, SeesLegsOfBoxesTouchAsOde) {
  const RobotDescription robot = hexapodOfBoxes();
  OdeWorld ode(robot, Physics());
  ReducedWorld reduced(robot, Physics());
  Random random(11);
  int touching = 0, apart = 0;
  for (int i = 0; i < 1500; ++i) {
    RobotDescription posed = robot;
    for (Leg& leg : posed.legs) {
      for (Segment& segment : leg.segments) segment.joint.neutral_rad = random.uniform(-1.0, 1.0);
    }
    const WorldState state = standingState(posed);
    ode.restore(state);
    reduced.restore(state);
    const Verdict expected = ode.step();
    ASSERT_EQ(reduced.step(), expected) << i;
    touching += expected == Verdict::kSelfCollided;
    apart += expected == Verdict::kWalked;
  }
  EXPECT_GT(touching, 150);
  EXPECT_GT(apart, 150);
}

TEST(ReducedWorld, SettlesAsOde) {
  const RobotDescription robot = handMadeHexapod();
  const OdeWorld ode(robot, Physics());
  const ReducedWorld reduced(robot, Physics());
  const Difference settled = difference(ode.state(), reduced.state(), robot.jointCount() + 1);
  EXPECT_LT(settled.pose, 1e-8);
  EXPECT_LT(settled.velocity, 1e-6);
}

TEST(ReducedWorld, MeasuresPoseAndAnglesAsOde) {
  const RobotDescription robot = handMadeHexapod();
  OdeWorld ode(robot, Physics());
  ReducedWorld reduced(robot, Physics());
  ode.setTargets(std::vector<double>(robot.jointCount(), 0.3));
  for (int i = 0; i < 10; ++i) ode.step();
  reduced.restore(ode.state());
  std::vector<double> expected, angles;
  ode.jointAngles(expected);
  reduced.jointAngles(angles);
  ASSERT_EQ(angles.size(), expected.size());
  for (std::size_t j = 0; j < angles.size(); ++j) EXPECT_NEAR(angles[j], expected[j], 1e-14);
  EXPECT_TRUE(reduced.worldFromBase().isApprox(ode.worldFromBase(), 1e-15));
}

TEST(ReducedWorld, GivesTheSameBitsFromTheSameStateWhateverRanBefore) {
  const RobotDescription robot = handMadeHexapod();
  ReducedWorld used(robot, Physics()), fresh(robot, Physics());
  const Behavior first(robot, randomGenomes(robot, 1, 1)[0], shortBehavior());
  const Behavior second(robot, randomGenomes(robot, 1, 2)[0], shortBehavior());
  const auto play = [](ReducedWorld& world, const Behavior& behavior) {
    for (std::size_t k = 0; k < behavior.commandCount(); ++k) {
      world.setTargets(behavior.command(k));
      world.step();
      world.step();
    }
    return world.state().values;
  };
  play(used, first);
  used.restart();
  EXPECT_EQ(play(used, second), play(fresh, second));
  const WorldState middle = used.state();
  const auto once = play(used, first);
  used.restore(middle);
  EXPECT_EQ(play(used, first), once);
}

TEST(ReducedWorld, SaysFellWhenTheBaseLiesOnTheFloorAndWhenItIsThrownUp) {
  const RobotDescription robot = handMadeHexapod();
  for (const double height_m : {-0.5, 0.6}) {
    ReducedWorld world(robot, Physics());
    WorldState moved = world.state();
    for (std::size_t body = 0; body <= robot.jointCount(); ++body) {
      moved.values[body * kStateValuesPerBody + 2] += height_m;
    }
    world.restore(moved);
    EXPECT_EQ(world.step(), Verdict::kFell) << height_m;
  }
}

TEST(ReducedWorld, SaysFellOfARobotThatIsUpsideDown) {
  // Its legs may hold the base off the floor on either side.
  ReducedWorld world(handMadeHexapod(), Physics());
  const WorldState upright = world.state();
  world.restore(rolled(world.robot(), upright, 0.49 * M_PI, 0.2));
  EXPECT_EQ(world.step(), Verdict::kWalked);
  world.restore(rolled(world.robot(), upright, 0.51 * M_PI, 0.2));
  EXPECT_EQ(world.step(), Verdict::kFell);
}

TEST(ReducedWorld, StaysDivergedUntilItIsRestored) {
  const RobotDescription robot = handMadeHexapod();
  ReducedWorld world(robot, Physics());
  WorldState broken = world.state();
  broken.values[40] = std::numeric_limits<double>::quiet_NaN();
  world.restore(broken);
  EXPECT_EQ(world.step(), Verdict::kDiverged);
  EXPECT_EQ(world.step(), Verdict::kDiverged);
  world.restart();
  EXPECT_EQ(world.step(), Verdict::kWalked);
}

TEST(ReducedWorld, RefusesStatesAndTargetsOfAnotherSize) {
  ReducedWorld world(handMadeHexapod(), Physics());
  EXPECT_THROW(world.restore(WorldState{{1.0, 2.0}}), std::invalid_argument);
  EXPECT_THROW(world.setTargets({1.0}), std::invalid_argument);
}

std::string refusal(const RobotDescription& robot) {
  std::string reason;
  EXPECT_FALSE(coversRobot(robot, reason));
  EXPECT_THROW(ReducedWorld(robot, Physics()), std::invalid_argument);
  EXPECT_NE(reason.find("use engine ode"), std::string::npos) << reason;
  return reason;
}

TEST(ReducedWorld, SaysWhichRobotsItDoesNotCover) {
  std::string reason;
  EXPECT_TRUE(coversRobot(handMadeHexapod(), reason));
  EXPECT_EQ(reason, "");

  RobotDescription jointed = handMadeHexapod();
  for (int i = 0; i < 2; ++i) jointed.legs[3].segments.push_back(jointed.legs[3].segments.back());
  EXPECT_NE(refusal(jointed).find("'leg_3' has 5"), std::string::npos);

  RobotDescription crowded = handMadeHexapod();
  std::vector<Shape>& shapes = crowded.legs[1].segments[2].body.shapes;
  shapes.resize(50, shapes.front());
  EXPECT_NE(refusal(crowded).find("67 on the legs (at most 64)"), std::string::npos);
  const EngineChoice choice = chooseEngine("reduced", crowded);
  EXPECT_EQ(choice.engine, Engine::kOde);
  EXPECT_NE(choice.remark.find("a hundred times as slow"), std::string::npos) << choice.remark;

  RobotDescription hard = handMadeHexapod();
  hard.contact.slip_per_n_s = 0.0;
  EXPECT_NE(refusal(hard).find("slip_per_n_s"), std::string::npos);

  RobotDescription soft = handMadeHexapod();
  soft.contact.joint_cfm = 1e-3;
  EXPECT_NE(refusal(soft).find("joint_cfm"), std::string::npos);

  RobotDescription stiff = handMadeHexapod();
  stiff.legs[0].segments[0].joint.upper_rad = stiff.legs[0].segments[0].joint.lower_rad;
  EXPECT_NE(refusal(stiff).find("'hip_0'"), std::string::npos);
}

}  // namespace
}  // namespace hexapod
