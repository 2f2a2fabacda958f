#pragma once

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <chrono>
#include <string>

#include "learning/learning_session.h"
#include "ros_interface/learner/repertoire_publisher.h"

namespace hexapod {

/// Options of the learner node: those of the run, and how it is published.
struct LearnerOptions {
  LearnOptions learn;
  std::string robot_config;
  double publish_period_s = 10.0;
  bool exit_when_done = false;
};

/// The options under their names, bound to `options`, which must outlive them.
std::vector<Option> declareOptions(LearnerOptions& options);

/// Shows a LearningSession to ROS: repertoire and markers when they changed (at most every
/// publish_period_s), ~progress once a second, paused or not, and a line on the terminal, ~save and
/// ~pause.
class LearnerNode {
 public:
  /// Throws as LearningSession does, and for a robot description that is missing or wrong.
  LearnerNode(ros::NodeHandle& node, ros::NodeHandle& private_node, const LearnerOptions& options);

  /// Learns in the calling thread until done or ROS shuts down; with exit_when_done false it goes
  /// on serving then. What could not be saved is tried again all the while, and some times more
  /// before it returns. Returns the exit code: 0 when all that was learned is in the file.
  int run();

  /// What was learned, where it is and what to do with it; or what went wrong.
  std::string lastWords() const;

 private:
  using SteadyClock = std::chrono::steady_clock;

  bool learn();
  void progress();
  void waitWhilePaused();
  void publishProgress(const LearningStatus& status);
  void retrySaving();
  bool save(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool pause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);

  LearnerOptions options_;
  LearningSession session_;
  RepertoirePublisher repertoire_publisher_;
  ros::Publisher progress_publisher_;
  ros::ServiceServer save_;
  ros::ServiceServer pause_;
  std::atomic<bool> paused_{false};
  std::atomic<bool> ended_{false};
  std::string run_id_;
  SteadyClock::time_point told_{};
  SteadyClock::time_point logged_{};
  LearningPhase logged_phase_ = LearningPhase::kEvolving;
  SteadyClock::time_point published_{};
  SteadyClock::time_point complained_{};
};

}  // namespace hexapod
