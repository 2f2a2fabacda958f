#include "ros_interface/browser/browser_options.h"

namespace hexapod {

std::vector<Option> declareOptions(BrowserOptions& options) {
  std::vector<Option> all = {
      option("robot_config", options.robot_config, "YAML file of the robot: legs, gait, servo."),
      option("player", options.player,
             "Who plays the behaviour that is clicked in rviz: `model`: the model in rviz, by "
             "simulation, on joint_states and tf; `robot`: the robot, by its executor.",
             {Player::kModel, Player::kRobot}),
      option("play_best", options.play_best,
             "The model plays the best behaviour again and again while none has been clicked."),
  };
  const std::vector<Option> pose = declareOptions(options.pose);
  all.insert(all.end(), pose.begin(), pose.end());
  return all;
}

}  // namespace hexapod
