#include "robot/load_robot.h"

#include "common/problems.h"
#include "robot/assemble_robot.h"
#include "robot/check_source.h"
#include "robot/digest.h"
#include "robot/robot_config.h"
#include "robot/urdf_bodies.h"

namespace hexapod {

RobotDescription loadRobot(const std::string& urdf_file, const std::string& yaml_file) {
  Problems problems;
  const std::string urdf_text = readSource(urdf_file, problems);
  const std::string yaml_text = readSource(yaml_file, problems);
  problems.throwIfAny();
  return parseRobot(urdf_text, yaml_text, urdf_file, yaml_file);
}

RobotDescription parseRobot(const std::string& urdf_text, const std::string& yaml_text,
                            const std::string& urdf_name, const std::string& yaml_name) {
  Problems problems;
  const RobotConfig config = parseRobotConfig(yaml_text, yaml_name, problems);
  const auto model = parseUrdf(urdf_text, urdf_name, problems);
  // Joining half-read files would only tell the same problems again in other words.
  problems.throwIfAny();
  RobotDescription robot = assembleRobot({*model, config, urdf_name, yaml_name}, problems);
  problems.throwIfAny();
  applyScales(config.calibration, robot);
  robot.digest = digestOf(robot);
  return robot;
}

}  // namespace hexapod
