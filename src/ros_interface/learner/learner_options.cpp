#include "ros_interface/learner/learner_options.h"

namespace hexapod {

std::vector<Option> declareOptions(LearnerOptions& options) {
  std::vector<Option> all = declareOptions(options.learn);
  all.push_back(option("robot_config", options.robot_config,
                       "YAML of the robot: legs, gait, servo, contact (config/hexapod.yaml)."));
  all.push_back(option("publish_period_s", options.publish_period_s, "s",
                       "The growing repertoire is published at most this often.", 0.1, 86400.0));
  all.push_back(option("exit_when_done", options.exit_when_done,
                       "End when the budget is used up; false: go on publishing."));
  all.push_back(option("start_paused", options.start_paused,
                       "Learn nothing before ~pause is called with false."));
  const std::vector<Option> pose = declareOptions(options.pose);
  all.insert(all.end(), pose.begin(), pose.end());
  return all;
}

}  // namespace hexapod
