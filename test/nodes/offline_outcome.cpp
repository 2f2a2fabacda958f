// offline_outcome <urdf> <yaml> <genome> <steps>: prints "x y yaw digest" of a behaviour that
// begins after so many simulation steps of standing.
#include <iomanip>
#include <iostream>

#include "robot/load_robot.h"
#include "simulation/rollout.h"

namespace hexapod {
namespace {

int printOutcome(const std::string& urdf, const std::string& yaml, const std::string& digits,
                 int steps) {
  const RobotDescription robot = loadRobot(urdf, yaml);
  const BehaviorOptions options;
  const Genome genome = genomeFromString(digits);
  const auto world = makeWorld(Engine::kOde, robot, Physics());
  world->restart();
  for (int i = 0; i < steps; ++i) world->step();
  const Outcome outcome = play(*world, Behavior(robot, genome, options), options.command_period_s);
  if (!outcome.walked()) return 1;
  std::cout << std::setprecision(17) << outcome.end_pose.x_m << " " << outcome.end_pose.y_m << " "
            << outcome.end_pose.yaw_rad << " " << robot.digest << std::endl;
  return 0;
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  return hexapod::printOutcome(argv[1], argv[2], argv[3], std::stoi(argv[4]));
}
