#include "ros_interface/learner/learner_core.h"

#include <ros/console.h>

#include <iostream>
#include <utility>

namespace hexapod {
namespace {

constexpr double kTellPeriod_s = 1.0;
constexpr double kLogPeriod_s = 5.0;
constexpr double kComplainPeriod_s = 10.0;
constexpr std::int64_t kPoll_ns = kSecond_ns / 20;
// A save that failed is tried again now and then while there is time, and so often at the end.
constexpr double kRetryPeriod_s = 10.0;
constexpr std::int64_t kLastRetryPeriod_ns = kSecond_ns / 2;
constexpr int kLastTries = 5;

std::string lost(const std::string& problem) {
  return problem + " What was learned since is lost.";
}

}  // namespace

bool LearnerCore::Now::isDue(std::int64_t now_ns, double period_s) {
  if (last_ns_ && now_ns - *last_ns_ < secondsToNs(period_s)) return false;
  last_ns_ = now_ns;
  return true;
}

LearnerCore::LearnerCore(const RobotDescription& robot, const LearnerOptions& options,
                         const Clock& clock, LearnerAudience& audience,
                         std::function<bool()> leaves, TrialRobot* trial_robot)
    : options_(options),
      clock_(clock),
      audience_(audience),
      leaves_(std::move(leaves)),
      session_(
          robot, options.learn,
          [&clock] { return 1e-9 * static_cast<double>(clock.steadyNow_ns()); }, {}, trial_robot),
      display_(std::cout, ProgressDisplay::forStandardOutput(kLogPeriod_s),
               [](const std::string& line) { ROS_INFO_STREAM(line); }),
      run_id_(session_.repertoire().run_id),
      paused_(options.start_paused) {}

LearnerCore::Answer LearnerCore::save() {
  const std::string problem = session_.saveNow();
  if (!problem.empty()) return {false, problem};
  return {true, "Written to " + options_.learn.repertoire_file + "."};
}

LearnerCore::Answer LearnerCore::pause(bool pause) {
  if (ended_) return {false, "Learning has ended: there is nothing to pause."};
  paused_ = pause;
  return {true, pause ? "Pausing after the generation, or the entry, under way." : "Going on."};
}

int LearnerCore::run() {
  display_.say("Learning run " + run_id_ + ": " +
               std::to_string(session_.status().evaluations_budget) + " evaluations into " +
               options_.learn.repertoire_file + ".");
  if (!session_.startRemark().empty()) display_.say(session_.startRemark());
  if (!session_.engineRemark().empty()) ROS_WARN_STREAM(session_.engineRemark());
  tellHistory();
  waitWhilePaused();
  LearningSession::Hooks hooks;
  hooks.progress = [this](const LearningSession&) { onProgress(); };
  hooks.save_failed = [this](const std::string& problem) {
    complain(problem + " Saving will be tried again.");
  };
  hooks.tried = [this](const std::string& sentence) { display_.say(sentence); };
  hooks.trial_failed = [this](const std::string& problem) {
    display_.clear();
    ROS_WARN_STREAM("An entry could not be tried on the robot: "
                    << problem << " Learning goes on; the next ones are tried later.");
  };
  const bool finished = session_.run(hooks);
  ended_ = true;
  display_.clear();
  const std::string remark = session_.verificationRemark();
  if (!remark.empty()) ROS_WARN_STREAM(remark);
  if (finished && !options_.exit_when_done && session_.saveProblem().empty()) {
    display_.say("Saved in " + options_.learn.repertoire_file + "; published until Ctrl-C.");
  }
  while (finished && !options_.exit_when_done && !leaves_()) {
    if (isDue(tried_, kRetryPeriod_s)) retrySaving();
    sleep(kPoll_ns);
  }
  for (int tries = 0; tries < kLastTries && !session_.saveProblem().empty(); ++tries) {
    clock_.sleepUntil(clock_.steadyNow_ns() + kLastRetryPeriod_ns);
    retrySaving();
  }
  const std::string problem = session_.saveProblem();
  if (problem.empty()) return 0;
  ROS_ERROR_STREAM(lost(problem));
  return 1;
}

std::string LearnerCore::lastWords() const {
  const std::string problem = session_.saveProblem();
  if (!problem.empty()) return lost(problem);
  const std::string& file = options_.learn.repertoire_file;
  return std::to_string(session_.status().entries) + " entries in " + file +
         ". To walk with them: ./run walk repertoire_file:=" + file +
         "; to look at them: ./run view repertoire_file:=" + file;
}

void LearnerCore::complain(const std::string& problem) {
  if (!isDue(complained_, kComplainPeriod_s)) return;
  display_.clear();
  ROS_ERROR_STREAM(problem);
}

void LearnerCore::retrySaving() {
  if (session_.saveProblem().empty()) return;
  const std::string problem = session_.saveNow();
  if (problem.empty()) {
    display_.say("The repertoire is saved now.");
  } else {
    complain(problem);
  }
}

void LearnerCore::onProgress() {
  const LearningStatus status = session_.status();
  const bool done = status.phase == LearningPhase::kDone;
  if (done) ended_ = true;
  if (isDue(told_, kTellPeriod_s) || done) tell(status);
  tellHistory();
  display_.show(status, 1e-9 * static_cast<double>(clock_.steadyNow_ns()));
  const bool evolving = status.phase == LearningPhase::kEvolving;
  if (done || (evolving && isDue(shown_, options_.publish_period_s))) {
    audience_.show(session_.repertoire());
  }
  if (!done) waitWhilePaused();
}

void LearnerCore::waitWhilePaused() {
  if (paused_) display_.say("Paused; Start in rviz, or ~pause with false, goes on.");
  while (paused_ && !leaves_()) {
    if (isDue(told_, kTellPeriod_s)) tell(session_.status());
    sleep(kPoll_ns);
  }
}

void LearnerCore::sleep(std::int64_t ns) const {
  clock_.waitUntil(clock_.steadyNow_ns() + ns, leaves_);
}

void LearnerCore::tellHistory() {
  const std::vector<HistoryRow>& rows = session_.history();
  if (rows.size() == told_rows_) return;
  told_rows_ = rows.size();
  hexapod_repertoire::LearningHistory message;
  message.header.stamp = clock_.rosNow();
  message.run_id = run_id_;
  for (const HistoryRow& row : rows) {
    message.evaluations.push_back(row.evaluations);
    message.sparseness_m.push_back(row.sparseness_m);
    message.median_orientation_error_rad.push_back(row.median_orientation_error_rad);
  }
  audience_.tell(message);
}

void LearnerCore::tell(const LearningStatus& status) {
  hexapod_repertoire::LearningProgress message;
  message.header.stamp = clock_.rosNow();
  message.run_id = run_id_;
  message.phase = paused_ ? "paused" : toString(status.phase);
  message.generation = status.counters.generations;
  message.evaluations = status.counters.evaluations;
  message.evaluations_budget = status.evaluations_budget;
  message.simulations = status.simulations;
  message.known = status.known;
  message.evaluations_per_s = status.evaluations_per_s;
  message.eta_s = status.left_s;
  message.archive_size = status.entries;
  message.sparseness_m = status.last.sparseness_m;
  message.median_orientation_error_rad = status.last.median_orientation_error_rad;
  message.max_reach_m = status.last.max_reach_m;
  message.fell = status.counters.fell;
  message.self_collided = status.counters.self_collided;
  message.diverged = status.counters.diverged;
  audience_.tell(message);
}

}  // namespace hexapod
