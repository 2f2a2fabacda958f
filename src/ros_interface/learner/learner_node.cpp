#include "ros_interface/learner/learner_node.h"

#include <ros/ros.h>

#include <thread>

#include "hexapod_repertoire/LearningProgress.h"
#include "learning/learning_report.h"
#include "ros_interface/common/node_process.h"
#include "ros_interface/common/robot_param.h"

namespace hexapod {
namespace {

using std::chrono::duration;
using std::chrono::milliseconds;

constexpr double kTellPeriod_s = 1.0;
constexpr double kLogPeriod_s = 5.0;
constexpr double kComplainPeriod_s = 10.0;
constexpr milliseconds kPoll{50};
// A save that failed is tried again now and then while there is time, and so often at the end.
constexpr double kRetryPeriod_s = 10.0;
constexpr milliseconds kLastRetryPeriod{500};
constexpr int kLastTries = 5;

double seconds(std::chrono::steady_clock::time_point time) {
  return duration<double>(time.time_since_epoch()).count();
}

bool due(std::chrono::steady_clock::time_point& last, double period_s) {
  const auto now = std::chrono::steady_clock::now();
  if (seconds(now) - seconds(last) < period_s) return false;
  last = now;
  return true;
}

}  // namespace

std::vector<Option> declareOptions(LearnerOptions& options) {
  std::vector<Option> all = declareOptions(options.learn);
  all.push_back(option("robot_config", options.robot_config,
                       "YAML of the robot: legs, gait, servo, contact (config/hexapod.yaml)."));
  all.push_back(option("publish_period_s", options.publish_period_s, "s",
                       "The growing repertoire is published at most this often.", 0.1, 86400.0));
  all.push_back(option("exit_when_done", options.exit_when_done,
                       "End when the budget is used up; false: go on publishing."));
  return all;
}

LearnerNode::LearnerNode(ros::NodeHandle& node, ros::NodeHandle& private_node,
                         const LearnerOptions& options)
    : options_(options),
      session_(robotFromParams(node, options.robot_config), options.learn,
               [] { return seconds(SteadyClock::now()); }),
      repertoire_publisher_(node),
      progress_publisher_(
          private_node.advertise<hexapod_repertoire::LearningProgress>("progress", 1, true)),
      save_(private_node.advertiseService("save", &LearnerNode::save, this)),
      pause_(private_node.advertiseService("pause", &LearnerNode::pause, this)),
      run_id_(session_.repertoire().run_id) {}

bool LearnerNode::save(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  const std::string problem = session_.saveNow();
  response.success = problem.empty();
  response.message =
      problem.empty() ? "Written to " + options_.learn.repertoire_file + "." : problem;
  return true;
}

bool LearnerNode::pause(std_srvs::SetBool::Request& request,
                        std_srvs::SetBool::Response& response) {
  response.success = !ended_;
  if (ended_) {
    response.message = "Learning has ended: there is nothing to pause.";
    return true;
  }
  paused_ = request.data;
  response.message =
      request.data ? "Pausing after the generation, or the entry, under way." : "Going on.";
  return true;
}

int LearnerNode::run() {
  const LearningStatus status = session_.status();
  ROS_INFO_STREAM("Learning run " << run_id_ << ": " << status.evaluations_budget
                                  << " evaluations into " << options_.learn.repertoire_file << ".");
  if (!session_.resumeRemark().empty()) ROS_INFO_STREAM(session_.resumeRemark());
  if (!session_.engineRemark().empty()) ROS_WARN_STREAM(session_.engineRemark());
  const bool finished = learn();
  ended_ = true;
  const std::string remark = session_.verificationRemark();
  if (!remark.empty()) ROS_WARN_STREAM(remark);
  SteadyClock::time_point tried = SteadyClock::now();
  while (finished && !options_.exit_when_done && !askedToLeave()) {
    if (due(tried, kRetryPeriod_s)) retrySaving();
    std::this_thread::sleep_for(kPoll);
  }
  for (int tries = 0; tries < kLastTries && !session_.saveProblem().empty(); ++tries) {
    std::this_thread::sleep_for(kLastRetryPeriod);
    retrySaving();
  }
  const std::string problem = session_.saveProblem();
  if (problem.empty()) return 0;
  ROS_ERROR_STREAM(problem << " What was learned since is lost.");
  return 1;
}

std::string LearnerNode::lastWords() const {
  const std::string problem = session_.saveProblem();
  if (!problem.empty()) return problem + " What was learned since is lost.";
  const std::string& file = options_.learn.repertoire_file;
  return std::to_string(session_.status().entries) + " entries in " + file +
         ". To walk with them: ./run walk repertoire_file:=" + file +
         "; to look at them: ./run view "
         "repertoire_file:=" +
         file;
}

bool LearnerNode::learn() {
  LearningSession::Hooks hooks;
  hooks.progress = [this](const LearningSession&) { progress(); };
  hooks.save_failed = [this](const std::string& problem) {
    if (due(complained_, kComplainPeriod_s)) {
      ROS_ERROR_STREAM(problem << " Saving will be tried again.");
    }
  };
  // ROS's shutdown must reach into a generation under way.
  std::atomic<bool> ended{false};
  std::thread watch([this, &ended] {
    while (!askedToLeave() && !ended) std::this_thread::sleep_for(kPoll);
    session_.requestStop();
  });
  const auto join = [&] {
    ended = true;
    watch.join();
  };
  try {
    const bool finished = session_.run(hooks);
    join();
    return finished;
  } catch (...) {
    join();
    throw;
  }
}

void LearnerNode::retrySaving() {
  if (session_.saveProblem().empty()) return;
  const std::string problem = session_.saveNow();
  if (problem.empty()) ROS_INFO_STREAM("The repertoire is saved now.");
  if (!problem.empty() && due(complained_, kComplainPeriod_s)) ROS_ERROR_STREAM(problem);
}

void LearnerNode::progress() {
  const LearningStatus status = session_.status();
  const bool done = status.phase == LearningPhase::kDone;
  if (done) ended_ = true;
  if (due(told_, kTellPeriod_s) || done) {
    publishProgress(status);
  }
  const bool changed = status.phase != logged_phase_;
  if (due(logged_, changed ? 0.0 : kLogPeriod_s)) {
    logged_phase_ = status.phase;
    ROS_INFO_STREAM(describe(status));
  }
  const bool evolving = status.phase == LearningPhase::kEvolving;
  if (done || (evolving && due(published_, options_.publish_period_s))) {
    repertoire_publisher_.publish(session_.repertoire());
  }
  if (!done) waitWhilePaused();
}

void LearnerNode::waitWhilePaused() {
  while (paused_ && !askedToLeave()) {
    if (due(told_, kTellPeriod_s)) publishProgress(session_.status());
    std::this_thread::sleep_for(kPoll);
  }
}

void LearnerNode::publishProgress(const LearningStatus& status) {
  hexapod_repertoire::LearningProgress message;
  message.header.stamp = ros::Time::now();
  message.run_id = run_id_;
  message.phase = paused_ ? "paused" : toString(status.phase);
  message.generation = status.counters.generations;
  message.evaluations = status.counters.evaluations;
  message.evaluations_budget = status.evaluations_budget;
  message.simulations = status.simulations;
  message.known = status.known;
  message.evaluations_per_s = status.evaluations_per_s;
  message.eta_s = status.eta_s;
  message.archive_size = status.entries;
  message.sparseness_m = status.last.sparseness_m;
  message.median_orientation_error_rad = status.last.median_orientation_error_rad;
  message.max_reach_m = status.last.max_reach_m;
  message.fell = status.counters.fell;
  message.self_collided = status.counters.self_collided;
  message.diverged = status.counters.diverged;
  progress_publisher_.publish(message);
}

}  // namespace hexapod
