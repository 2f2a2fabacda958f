#include "simulation/ode/ode_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <thread>

#include "geometry/pose2.h"
#include "simulation/kinematics.h"
#include "simulation/physics.h"
#include "simulation/rollout.h"
#include "simulation/standing_state.h"
#include "test_robots.h"

namespace hexapod {
namespace {

// One settled world for all tests that start by restarting it; its life is that of the suite.
class OdeWorldTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { world_ = new OdeWorld(handMadeHexapod(), Physics()); }
  static void TearDownTestSuite() {
    delete world_;
    world_ = nullptr;
  }

  void SetUp() override { world_->restart(); }

  static Eigen::Vector3d position(const WorldState& state, std::size_t body) {
    return Eigen::Map<const Eigen::Vector3d>(&state.values[body * kStateValuesPerBody]);
  }

  static Eigen::Vector3d centerOfMass(const WorldState& state) {
    Eigen::Vector3d weighted = Eigen::Vector3d::Zero();
    double mass_kg = 0.0;
    const std::vector<const Body*> links = bodies(world_->robot());
    for (std::size_t b = 0; b < links.size(); ++b) {
      weighted += links[b]->mass_kg * position(state, b);
      mass_kg += links[b]->mass_kg;
    }
    return weighted / mass_kg;
  }

  // The settled stand, lifted and at rest.
  static WorldState lifted(double height_m) {
    WorldState state = world_->state();
    for (std::size_t b = 0; b < bodies(world_->robot()).size(); ++b) {
      state.values[b * kStateValuesPerBody + 2] += height_m;
      std::fill_n(&state.values[b * kStateValuesPerBody + kVelocity], 6, 0.0);
    }
    return state;
  }

  static Verdict stepped(int steps) {
    Verdict verdict = Verdict::kWalked;
    for (int i = 0; i < steps; ++i) verdict = world_->step();
    return verdict;
  }

  static OdeWorld* world_;
};

OdeWorld* OdeWorldTest::world_ = nullptr;

TEST_F(OdeWorldTest, StartsAtTheOriginHeadingForward) {
  const Pose2 start = footprint(world_->worldFromBase());
  EXPECT_NEAR(start.x_m, 0.0, 1e-15);
  EXPECT_NEAR(start.y_m, 0.0, 1e-15);
  EXPECT_NEAR(start.yaw_rad, 0.0, 1e-15);
  EXPECT_NEAR(world_->worldFromBase().translation().z(), standingHeight(world_->robot()), 1e-3);
}

TEST_F(OdeWorldTest, PutsTheFootprintAtTheOriginForARobotThatTurnsWhileItSettles) {
  RobotDescription robot = handMadeHexapod();
  robot.base.center_of_mass_m = Eigen::Vector3d(0.03, 0.04, 0.01);
  for (std::size_t leg = 0; leg < 6; ++leg) robot.legs[leg].segments[0].joint.neutral_rad = 0.2;
  robot.legs[2].segments[1].joint.neutral_rad = -0.2;
  const OdeWorld world(robot, Physics());
  const Pose2 start = footprint(world.worldFromBase());
  EXPECT_NEAR(start.x_m, 0.0, 1e-15);
  EXPECT_NEAR(start.y_m, 0.0, 1e-15);
  EXPECT_NEAR(start.yaw_rad, 0.0, 1e-15);
}

TEST_F(OdeWorldTest, HingesTurnAsTheDescriptionSays) {
  std::vector<double> targets_rad = world_->robot().neutralPose();
  for (std::size_t j = 0; j < targets_rad.size(); ++j) targets_rad[j] += 0.02 * (j % 5) - 0.03;
  world_->setTargets(targets_rad);
  stepped(60);
  std::vector<double> angles_rad;
  world_->jointAngles(angles_rad);
  const std::vector<Eigen::Isometry3d> base_from_bodies =
      baseFromBodies(world_->robot(), angles_rad);
  const std::vector<const Body*> links = bodies(world_->robot());
  const WorldState state = world_->state();
  for (std::size_t b = 0; b < links.size(); ++b) {
    const Eigen::Vector3d expected =
        world_->worldFromBase() * base_from_bodies[b] * links[b]->center_of_mass_m;
    EXPECT_LT((position(state, b) - expected).norm(), 2e-4) << links[b]->name;
  }
  for (std::size_t j = 0; j < targets_rad.size(); ++j) {
    EXPECT_NEAR(angles_rad[j], targets_rad[j], 5e-3) << j;
  }
}

TEST_F(OdeWorldTest, ServosAreNoFasterThanTheirLimit) {
  world_->restore(lifted(0.2));
  std::vector<double> targets_rad = world_->robot().neutralPose();
  targets_rad[1] = 1.5;  // 16/s * 1.5 rad is far beyond 6.28 rad/s
  world_->setTargets(targets_rad);
  std::vector<double> before_rad, after_rad;
  for (int i = 0; i < 8; ++i) {
    world_->jointAngles(before_rad);
    world_->step();
    world_->jointAngles(after_rad);
    EXPECT_LE(after_rad[1] - before_rad[1], 6.28 * 0.015 * 1.01);
  }
  EXPECT_GT(after_rad[1], 0.6);
}

TEST_F(OdeWorldTest, FallsAsSemiImplicitEulerDoes) {
  world_->restore(lifted(0.3));
  const Eigen::Vector3d start = centerOfMass(world_->state());
  const int n = 12;
  EXPECT_EQ(stepped(n), Verdict::kWalked);
  // v_n = -g h n, z_n = z_0 - g h^2 (1 + 2 + .. + n)
  const double h = 0.015;
  const Eigen::Vector3d expected(start.x(), start.y(), start.z() - 9.81 * h * h * n * (n + 1) / 2);
  EXPECT_LT((centerOfMass(world_->state()) - expected).norm(), 1e-12);
}

TEST_F(OdeWorldTest, ServosDoNotMoveTheCenterOfMassInTheAir) {
  world_->restore(lifted(0.3));
  std::vector<double> targets_rad = world_->robot().neutralPose();
  for (std::size_t j = 0; j < targets_rad.size(); ++j) targets_rad[j] += j % 2 == 0 ? 0.3 : -0.2;
  world_->setTargets(targets_rad);
  const Eigen::Vector3d start = centerOfMass(world_->state());
  stepped(12);
  const Eigen::Vector3d end = centerOfMass(world_->state());
  EXPECT_LT((end - start).head<2>().norm(), 1e-9);
}

TEST_F(OdeWorldTest, ContinuesFromAStoredStateToTheLastBit) {
  const Behavior walk(world_->robot(), tripod(world_->robot()), shortBehavior());
  play(*world_, walk, 0.030);
  const WorldState middle = world_->state();
  play(*world_, walk, 0.030);
  const WorldState end = world_->state();

  world_->restore(middle);
  EXPECT_EQ(world_->state().values, middle.values);
  play(*world_, walk, 0.030);
  EXPECT_EQ(world_->state().values, end.values);
}

TEST_F(OdeWorldTest, IsTheSameFreshReusedAndInAnotherThread) {
  const WorldState settled = world_->state();
  const Behavior walk(world_->robot(), tripod(world_->robot()), shortBehavior());
  play(*world_, walk, 0.030);
  const WorldState first = world_->state();

  for (const Genome& genome : randomGenomes(world_->robot(), 3, 5)) {
    play(*world_, Behavior(world_->robot(), genome, shortBehavior()), 0.030);
  }
  world_->restart();
  EXPECT_EQ(world_->state().values, settled.values);
  play(*world_, walk, 0.030);
  EXPECT_EQ(world_->state().values, first.values);

  WorldState elsewhere;
  WorldState moved_to;
  std::thread thread([&] {
    OdeWorld fresh(handMadeHexapod(), Physics());
    play(fresh, walk, 0.030);
    elsewhere = fresh.state();
    // A world may also go from one thread to another.
    world_->restart();
    play(*world_, walk, 0.030);
    moved_to = world_->state();
  });
  thread.join();
  EXPECT_EQ(elsewhere.values, first.values);
  EXPECT_EQ(moved_to.values, first.values);
}

TEST_F(OdeWorldTest, FallsWhenTheBodyTouchesTheFloor) {
  world_->restore(lifted(-0.13));
  EXPECT_EQ(world_->step(), Verdict::kFell);
}

TEST_F(OdeWorldTest, FallsWhenTheBodyIsAboveTheAllowedHeight) {
  world_->restore(lifted(0.3));
  EXPECT_EQ(world_->step(), Verdict::kWalked);
  world_->restore(lifted(0.4));
  EXPECT_EQ(world_->step(), Verdict::kFell);
}

TEST_F(OdeWorldTest, FallsWhenTheBodyIsUpsideDown) {
  const WorldState upright = world_->state();
  world_->restore(rolled(world_->robot(), upright, 0.49 * M_PI, 0.2));
  EXPECT_EQ(world_->step(), Verdict::kWalked);
  world_->restore(rolled(world_->robot(), upright, 0.51 * M_PI, 0.2));
  EXPECT_EQ(world_->step(), Verdict::kFell);
}

TEST_F(OdeWorldTest, AFallenRobotLiesOnTheFloor) {
  std::vector<double> targets_rad = world_->robot().neutralPose();
  for (std::size_t leg = 0; leg < 6; ++leg) targets_rad[3 * leg + 1] = 1.5;
  world_->setTargets(targets_rad);
  EXPECT_EQ(stepped(100), Verdict::kFell);
  EXPECT_NEAR(world_->worldFromBase().translation().z(), 0.02, 0.005);
}

TEST_F(OdeWorldTest, CollidesWithItselfWhenNeighbouringLegsMeet) {
  std::vector<double> targets_rad = world_->robot().neutralPose();
  targets_rad[3] = -1.2;  // left middle leg forward
  targets_rad[6] = 1.2;   // left front leg backward
  world_->setTargets(targets_rad);
  Verdict verdict = Verdict::kWalked;
  for (int i = 0; i < 40 && verdict == Verdict::kWalked; ++i) verdict = world_->step();
  EXPECT_EQ(verdict, Verdict::kSelfCollided);
}

class OdeWorldDiverges : public OdeWorldTest {
 protected:
  // Diverged it stays; a restart makes it as good as new.
  static void expectDivergedUntilRestart(const WorldState& absurd, const WorldState& settled) {
    world_->restore(absurd);
    EXPECT_EQ(stepped(1), Verdict::kDiverged);
    EXPECT_EQ(stepped(3), Verdict::kDiverged);
    world_->restart();
    EXPECT_EQ(world_->state().values, settled.values);
    EXPECT_EQ(stepped(3), Verdict::kWalked);
  }
};

TEST_F(OdeWorldDiverges, WhenAVelocityIsAbsurd) {
  const WorldState settled = world_->state();
  WorldState absurd = settled;
  absurd.values[kVelocity] = 1e6;
  expectDivergedUntilRestart(absurd, settled);
}

TEST_F(OdeWorldDiverges, WhenAPositionIsNotANumber) {
  const WorldState settled = world_->state();
  WorldState absurd = settled;
  absurd.values[2 * kStateValuesPerBody] = std::nan("");
  expectDivergedUntilRestart(absurd, settled);
}

TEST_F(OdeWorldDiverges, WhenOdeStopsOnAnInternalError) {
  const WorldState settled = world_->state();
  WorldState absurd = settled;
  std::fill_n(&absurd.values[3], 4, 0.0);  // a quaternion of length 0 fails ODE's own assertion
  expectDivergedUntilRestart(absurd, settled);
  const Behavior walk(world_->robot(), tripod(world_->robot()), shortBehavior());
  world_->restart();
  play(*world_, walk, 0.030);
  const WorldState rebuilt = world_->state();
  OdeWorld fresh(handMadeHexapod(), Physics());
  play(fresh, walk, 0.030);
  EXPECT_EQ(rebuilt.values, fresh.state().values);
}

TEST_F(OdeWorldDiverges, WhenATargetIsNotANumber) {
  const WorldState settled = world_->state();
  world_->setTargets(std::vector<double>(18, std::nan("")));
  EXPECT_EQ(stepped(2), Verdict::kDiverged);
  expectDivergedUntilRestart(world_->state(), settled);
}

TEST_F(OdeWorldTest, RefusesStatesAndTargetsOfAnotherRobot) {
  EXPECT_THROW(world_->restore(WorldState{{1.0, 2.0}}), std::invalid_argument);
  EXPECT_THROW(world_->setTargets({0.0}), std::invalid_argument);
}

TEST(OdeWorld, RefusesARobotThatCannotStand) {
  Physics physics;
  physics.torque_scale = 0.0;
  try {
    OdeWorld world(handMadeHexapod(), physics);
    FAIL() << "stood without torque";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("does not stand"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("'fell'"), std::string::npos) << error.what();
  }
}

TEST(OdeWorld, RefusesPhysicsOutOfRange) {
  Physics physics;
  physics.step_s = -1.0;
  EXPECT_THROW(makeWorld(Engine::kOde, handMadeHexapod(), physics), std::invalid_argument);
}

}  // namespace
}  // namespace hexapod
