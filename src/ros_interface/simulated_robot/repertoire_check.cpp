#include "ros_interface/simulated_robot/repertoire_check.h"

namespace hexapod {

std::string wrongRobot(const hexapod_repertoire::Repertoire& repertoire,
                       const std::string& robot_id) {
  if (repertoire.robot_id.empty() || repertoire.robot_id == robot_id) return "";
  return "The repertoire of run '" + repertoire.run_id + "' was learned for the robot " +
         repertoire.robot_id + ", the simulated one is " + robot_id +
         "; give all nodes the same robot_description and ~robot_config.";
}

}  // namespace hexapod
