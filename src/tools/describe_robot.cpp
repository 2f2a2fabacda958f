// Prints a robot as URDF and YAML describe it, as YAML: its name and id, the engine that simulates
// it (and why not the fast one), and per leg the joints with their part in the gait and where the
// foot goes when they move alone.
#include <yaml-cpp/yaml.h>

#include <exception>
#include <iostream>

#include "robot/load_robot.h"
#include "robot_import/check_robot.h"
#include "simulation/world.h"

namespace hexapod {
namespace {

void emitJoint(YAML::Emitter& yaml, const Leg& leg, std::size_t index) {
  const Joint& joint = leg.segments[index].joint;
  yaml << YAML::BeginMap << YAML::Key << "name" << YAML::Value << joint.name;
  yaml << YAML::Key << "signal" << YAML::Value << static_cast<int>(joint.signal);
  yaml << YAML::Key << "neutral_rad" << YAML::Value << joint.neutral_rad;
  yaml << YAML::Key << "amplitude_rad" << YAML::Value << joint.amplitude_rad;
  yaml << YAML::Key << "foot" << YAML::Value << footWay(leg, index) << YAML::EndMap;
}

void emitLeg(YAML::Emitter& yaml, const Leg& leg) {
  yaml << YAML::BeginMap << YAML::Key << "name" << YAML::Value << leg.name;
  yaml << YAML::Key << "joints" << YAML::Value << YAML::BeginSeq;
  for (std::size_t j = 0; j < leg.segments.size(); ++j) emitJoint(yaml, leg, j);
  yaml << YAML::EndSeq << YAML::EndMap;
}

std::string describe(const RobotDescription& robot) {
  YAML::Emitter yaml;
  yaml.SetStringFormat(YAML::DoubleQuoted);
  yaml << YAML::BeginMap << YAML::Key << "name" << YAML::Value << robot.name;
  yaml << YAML::Key << "id" << YAML::Value << robot.digest;
  const EngineChoice choice = chooseEngine(engineNames().front(), robot);
  yaml << YAML::Key << "engine" << YAML::Value << toString(choice.engine);
  if (!choice.remark.empty()) yaml << YAML::Key << "engine_remark" << YAML::Value << choice.remark;
  yaml << YAML::Key << "legs" << YAML::Value << YAML::BeginSeq;
  for (const Leg& leg : robot.legs) emitLeg(yaml, leg);
  yaml << YAML::EndSeq << YAML::EndMap;
  return yaml.c_str();
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: describe_robot ROBOT.urdf ROBOT.yaml\n";
    return 2;
  }
  try {
    std::cout << hexapod::describe(hexapod::loadRobot(argv[1], argv[2])) << "\n";
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return 0;
}
