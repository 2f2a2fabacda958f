#include "simulation/reduced/solver.h"

#include <gtest/gtest.h>

#include <memory>

#include "simulation/reduced/make_model.h"
#include "simulation/reduced/reduced_world.h"
#include "simulation/reduced/stepper.h"
#include "test_robots.h"

namespace hexapod {
namespace {

/// Whether a step with all servos at their limits ends diverged when so many sets are tried.
bool divergesWithin(int most_solver_rounds) {
  const RobotDescription robot = handMadeHexapod();
  reduced::ReducedModel model = reduced::makeModel(robot, Physics());
  model.most_solver_rounds = most_solver_rounds;
  const std::unique_ptr<reduced::Stepper> stepper(
      reduced::makeScalarStepper(model, reduced::conditionsOf(robot, Physics(), Physics().step_s)));
  stepper->load(0, ReducedWorld(robot, Physics()).state().values.data());
  const std::vector<double> far(robot.jointCount(), 1.0);
  stepper->setTargets(0, far.data());
  stepper->advance();
  return stepper->findings(0).diverged;
}

TEST(Solver, CallsARobotDivergedForWhichItFindsNoSolution) {
  EXPECT_TRUE(divergesWithin(1));
  EXPECT_FALSE(divergesWithin(200));
}

}  // namespace
}  // namespace hexapod
