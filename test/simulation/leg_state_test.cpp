#include "simulation/leg_state.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "robot/load_robot.h"
#include "simulation/kinematics.h"
#include "simulation/ode/ode_world.h"
#include "simulation/reduced/batch_rollout.h"
#include "simulation/reduced/reduced_world.h"
#include "simulation/rollout.h"
#include "test_robots.h"

namespace hexapod {
namespace {

Physics withLegs(const RobotDescription& robot, const std::string& text) {
  Physics physics;
  physics.legs = legStatesFromText(robot, text);
  return physics;
}

std::string complaintOf(const RobotDescription& robot, const std::string& text) {
  try {
    legStatesFromText(robot, text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(LegState, IsReadFromTextAndToldAsText) {
  const RobotDescription robot = handMadeHexapod();
  const std::string first = robot.legs[0].name, last = robot.legs[5].name;
  const auto legs = legStatesFromText(robot, " " + last + ":limp , " + first + ": locked");
  ASSERT_EQ(legs.size(), 6u);
  EXPECT_EQ(legs[0].condition, LegCondition::kLocked);
  EXPECT_EQ(legs[1].condition, LegCondition::kIntact);
  EXPECT_EQ(legs[5].condition, LegCondition::kLimp);
  EXPECT_EQ(describeLegs(robot, legs), first + ": locked, " + last + ": limp");
  EXPECT_TRUE(legStatesFromText(robot, "").empty());
  EXPECT_EQ(describeLegs(robot, {}), "intact");
}

TEST(LegState, NamesTheWordThatIsNoLegOrCondition) {
  const RobotDescription robot = handMadeHexapod();
  const std::string leg = robot.legs[0].name;
  EXPECT_NE(complaintOf(robot, "tail: limp").find("'tail' is no leg; expected one of " + leg),
            std::string::npos);
  EXPECT_EQ(complaintOf(robot, leg + ": broken"),
            "'broken' is no condition of a leg; expected one of intact, locked, lifted, limp, "
            "missing.");
  EXPECT_NE(complaintOf(robot, leg).find("expected for example"), std::string::npos);
}

TEST(LegState, LiftsAShippedLegByItsSecondSignal) {
  const RobotDescription robot = loadRobot("urdf/hexapod.urdf", "config/hexapod.yaml");
  for (std::size_t leg = 0; leg < robot.legs.size(); ++leg) {
    const std::vector<double> angles_rad = liftedAngles(robot, leg);
    ASSERT_EQ(angles_rad.size(), 3u);
    EXPECT_DOUBLE_EQ(angles_rad[0], 0.0);
    EXPECT_NEAR(angles_rad[1], M_PI / 4, 1e-12);
    EXPECT_NEAR(angles_rad[2], -M_PI / 4, 1e-12);
  }
}

TEST(LegState, LiftsALegWhoseJointTurnsTheOtherWay) {
  RobotDescription robot = loadRobot("urdf/hexapod.urdf", "config/hexapod.yaml");
  for (Segment& segment : robot.legs[2].segments) segment.joint.amplitude_rad *= -1.0;
  EXPECT_NEAR(liftedAngles(robot, 2)[1], M_PI / 4, 1e-12);
}

TEST(LegState, OfTheWrongNumberIsRefused) {
  const RobotDescription robot = handMadeHexapod();
  Physics physics;
  physics.legs.resize(5);
  EXPECT_THROW(ReducedWorld(robot, physics), std::invalid_argument);
  EXPECT_THROW(OdeWorld(robot, physics), std::invalid_argument);
  physics.legs.assign(6, {LegCondition::kLocked, {0.1}});
  EXPECT_THROW(ReducedWorld(robot, physics), std::invalid_argument);
  Physics torques;
  torques.joint_torque_scales = {0.5};
  EXPECT_THROW(OdeWorld(robot, torques), std::invalid_argument);
}

// Everything that can be wrong with a body, in both engines and in a batch.
std::vector<Physics> variousBodies(const RobotDescription& robot) {
  const auto leg = [&](std::size_t i) { return robot.legs[i].name; };
  std::vector<Physics> bodies;
  for (const std::string& condition : legConditionNames()) {
    bodies.push_back(withLegs(robot, leg(1) + ": " + condition));
  }
  bodies.push_back(withLegs(robot, leg(1) + ": lifted, " + leg(4) + ": limp"));
  Physics askew = withLegs(robot, leg(2) + ": locked");
  askew.legs[2].locked_rad = {0.2, 0.1, -0.1};
  askew.friction_scale = 0.7;
  askew.slope_y_rad = 0.03;
  bodies.push_back(askew);
  Physics tired;
  tired.joint_torque_scales.assign(robot.jointCount(), 1.0);
  tired.joint_torque_scales[4] = 0.2;
  tired.command_latency_s = 0.045;
  bodies.push_back(tired);
  return bodies;
}

TEST(Body, WalksTheSameInBothEngines) {
  const RobotDescription robot = handMadeHexapod();
  const Behavior behavior(robot, tripod(robot), shortBehavior());
  for (const Physics& physics : variousBodies(robot)) {
    OdeWorld ode(robot, physics);
    ReducedWorld reduced(robot, physics);
    const Outcome expected = play(ode, behavior, 0.030), outcome = play(reduced, behavior, 0.030);
    EXPECT_EQ(outcome.verdict, expected.verdict) << describeLegs(robot, physics.legs);
    EXPECT_LT(distance(footprint(ode.worldFromBase()), footprint(reduced.worldFromBase())), 1e-5)
        << describeLegs(robot, physics.legs);
  }
}

TEST(Body, GetsTheSameBitsInABatch) {
  const RobotDescription robot = handMadeHexapod();
  const Behavior behavior(robot, tripod(robot), shortBehavior());
  for (const Physics& physics : variousBodies(robot)) {
    ReducedWorld world(robot, physics);
    BatchRollout batch(robot, physics);
    play(world, behavior, 0.030);
    EXPECT_EQ(batch.play({{&behavior, nullptr}}, 0.030)[0].end.values, world.state().values)
        << describeLegs(robot, physics.legs);
  }
}

TEST(Body, EndsElsewhereWithEveryDamage) {
  const RobotDescription robot = handMadeHexapod();
  const Behavior behavior(robot, tripod(robot), shortBehavior());
  std::vector<std::vector<double>> ends;
  for (const Physics& physics : variousBodies(robot)) {
    ReducedWorld world(robot, physics);
    play(world, behavior, 0.030);
    for (const std::vector<double>& other : ends) EXPECT_NE(other, world.state().values);
    ends.push_back(world.state().values);
  }
}

TEST(Body, ActsLateByItsLatency) {
  const RobotDescription robot = handMadeHexapod();
  const Behavior behavior(robot, tripod(robot), shortBehavior());
  Physics late;
  late.command_latency_s = 0.060;
  ReducedWorld delayed(robot, late), prompt(robot, Physics());
  play(delayed, behavior, 0.030);
  // The same by hand: every command two periods of two steps later.
  for (std::size_t k = 0; k < behavior.commandCount(); ++k) {
    if (k >= 2) prompt.setTargets(behavior.command(k - 2));
    prompt.step();
    prompt.step();
  }
  EXPECT_EQ(delayed.state().values, prompt.state().values);
}

TEST(Body, KeepsALockedLegWhereItIsLocked) {
  const RobotDescription robot = handMadeHexapod();
  ReducedWorld world(robot, withLegs(robot, robot.legs[1].name + ": lifted"));
  std::vector<double> angles_rad;
  const Behavior behavior(robot, tripod(robot), shortBehavior());
  play(world, behavior, 0.030);
  world.jointAngles(angles_rad);
  for (std::size_t s = 0; s < 3; ++s) {
    EXPECT_NEAR(angles_rad[3 + s], liftedAngles(robot, 1)[s], 0.02);
  }
}

double hipAfterCommand(const RobotDescription& robot, const Physics& physics) {
  ReducedWorld world(robot, physics);
  std::vector<double> targets_rad = robot.neutralPose();
  targets_rad[3] += 0.3;
  world.setTargets(targets_rad);
  for (int i = 0; i < 20; ++i) world.step();
  std::vector<double> angles_rad;
  world.jointAngles(angles_rad);
  return angles_rad[3] - robot.neutralPose()[3];
}

TEST(Body, FollowsNoCommandWithALimpLeg) {
  const RobotDescription robot = handMadeHexapod();
  EXPECT_GT(hipAfterCommand(robot, Physics()), 0.25);
  EXPECT_LT(std::abs(hipAfterCommand(robot, withLegs(robot, robot.legs[1].name + ": limp"))), 0.05);
}

TEST(Body, TouchesNothingWithALegThatIsNotDriven) {
  const RobotDescription robot = hexapodWithWideHips();
  const Behavior behavior(robot, tripod(robot), shortBehavior());
  const std::string front = robot.legs[0].name + ": limp, " + robot.legs[2].name + ": limp, " +
                            robot.legs[3].name + ": limp, " + robot.legs[5].name + ": limp";
  for (const Engine engine : {Engine::kOde, Engine::kReduced}) {
    EXPECT_EQ(play(*makeWorld(engine, robot, Physics()), behavior, 0.030).verdict,
              Verdict::kSelfCollided);
    // No two driven legs are neighbours any more.
    const WorldState stand = makeWorld(engine, robot, Physics())->state();
    const auto world = makeWorld(engine, robot, withLegs(robot, front), &stand);
    EXPECT_NE(play(*world, behavior, 0.030).verdict, Verdict::kSelfCollided);
  }
}

}  // namespace
}  // namespace hexapod
