#pragma once

#include <geometry_msgs/PoseStamped.h>

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "ros_interface/common/conversions.h"
#include "ros_interface/planner/walk_goal.h"
#include "ros_interface/planner/walk_watcher.h"
#include "ros_interface/robot_client/behavior_player.h"
#include "ros_interface/robot_client/pose_source.h"

namespace hexapod {

/// A pose that a test sets. Goals are taken as they are; those at x = `held_x_m` wait until
/// releaseGoals() or until they are ended.
class FakePoseSource : public PoseSource {
 public:
  PoseReading latest() const override {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++looks;
    return reading_;
  }
  PoseReading robotPose(const Stop&) const override { return latest(); }
  PoseReading restPose(const ros::Time&, const Stop&) const override { return latest(); }
  PoseReading goalPose(const geometry_msgs::PoseStamped& goal, const Stop& stop) const override {
    std::string problem;
    const auto pose = fromPoseMsg(goal.pose, problem);
    while (pose && pose->x_m == held_x_m && !released_ && !stop()) std::this_thread::yield();
    return {pose, problem};
  }

  void set(const PoseReading& reading) {
    const std::lock_guard<std::mutex> lock(mutex_);
    reading_ = reading;
  }
  void releaseGoals() { released_ = true; }

  double held_x_m = -1e9;
  mutable std::atomic<int> looks{0};

 private:
  mutable std::mutex mutex_;
  PoseReading reading_{Pose2(), ""};
  std::atomic<bool> released_{false};
};

/// Moves the robot of a FakePoseSource as the repertoire says. While `held`, a behaviour goes on
/// until it is interrupted or released; while `deaf`, one that was interrupted does not come back;
/// while `returning`, it is not ready for the next.
class FakePlayer : public BehaviorPlayer {
 public:
  explicit FakePlayer(FakePoseSource& poses) : poses_(poses) {}

  std::string whyNotReady() const override {
    const std::lock_guard<std::mutex> lock(mutex_);
    return problem_;
  }
  std::uint64_t stops() const override { return stops_; }

  Result awaitReady(std::uint64_t stops, const Interrupted& interrupted) override {
    while (returning && !interrupted()) std::this_thread::yield();
    if (interrupted()) return {End::kCancelled, "broken off", {}, 0};
    return {stops == stops_ ? End::kPlayed : End::kNotReady, "stopped since", ros::Time(2.0), 0};
  }

  Result play(const Order& order) override {
    ++begun;
    if (order.stops != stops_) return {End::kNotReady, "stopped since", {}, 0};
    while (held && !order.interrupted()) std::this_thread::yield();
    while (deaf) std::this_thread::yield();
    if (order.interrupted()) return {End::kCancelled, "broken off", {}, 0};
    const Result result = outcome ? outcome() : Result{End::kPlayed, "", ros::Time(1.0), 0};
    if (result.end == End::kPlayed) {
      poses_.set({*poses_.latest().pose * order.entry.expectedPose(), ""});
    }
    return result;
  }

  void becomeUnready(const std::string& problem) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!problem.empty()) ++stops_;
    problem_ = problem;
  }

  std::atomic<bool> held{false};
  std::atomic<bool> deaf{false};
  std::atomic<bool> returning{false};  // to the neutral pose
  std::atomic<int> begun{0};
  std::function<Result()> outcome;

 private:
  FakePoseSource& poses_;
  mutable std::mutex mutex_;
  std::string problem_;
  std::atomic<std::uint64_t> stops_{0};
};

/// Counts what it is shown.
class FakeWatcher : public WalkWatcher {
 public:
  void showGoal(const Pose2&) override { ++goals; }
  void showPlan(const Pose2&, const PlanResult&, const std::vector<WalkedStop>& walked,
                const Pose2&, double) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    stops_ = walked;
    ++plans;
  }
  void showRefused(const Pose2&, double, const WalkReport& report) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    refused_.push_back(report);
  }
  void reportStep(const std::string&, std::uint32_t, const PlannedStep&, const Pose2&,
                  const Pose2&) override {
    ++steps;
  }
  void reportWalk(const std::string&, const WalkReport& report) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    walks_.push_back(report);
  }
  std::vector<WalkReport> walks() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return walks_;
  }
  std::vector<WalkReport> refused() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return refused_;
  }
  /// Of the last plan.
  std::vector<WalkedStop> stops() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return stops_;
  }
  void tellStanding(const std::string&) override { ++standing; }

  std::atomic<int> goals{0};
  std::atomic<int> plans{0};
  std::atomic<int> steps{0};
  std::atomic<int> standing{0};

 private:
  mutable std::mutex mutex_;
  std::vector<WalkReport> walks_;
  std::vector<WalkReport> refused_;
  std::vector<WalkedStop> stops_;
};

/// Hears of a goal; waits for its end.
class Client {
 public:
  GoalListener listener() {
    GoalListener listener;
    listener.accepted = [this](const WalkReport&) { note([this] { ++accepted_; }); };
    listener.progress = [this](const WalkProgress&) {
      note([this] { progress_after_end_ = progress_after_end_ || !ends_.empty(); });
    };
    listener.ended = [this](const WalkReport& report) { note([&] { ends_.push_back(report); }); };
    return listener;
  }

  void waitForAcceptance() {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return accepted_ > 0 || !ends_.empty(); });
  }
  WalkReport waitForEnd() {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return !ends_.empty(); });
    return ends_.front();
  }

  std::size_t ends() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return ends_.size();
  }
  bool wasAccepted() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return accepted_ > 0;
  }
  bool heardProgressAfterTheEnd() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return progress_after_end_;
  }

 private:
  template <class Change>
  void note(const Change& change) {
    const std::lock_guard<std::mutex> lock(mutex_);
    change();
    changed_.notify_all();
  }

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  int accepted_ = 0;
  bool progress_after_end_ = false;
  std::vector<WalkReport> ends_;
};

/// A goal in the global frame.
inline GoalRequest goalAt(double x_m, double y_m, double yaw_rad) {
  GoalRequest request;
  request.pose.header.frame_id = "odom";
  request.pose.pose = toPoseMsg({x_m, y_m, yaw_rad});
  return request;
}

}  // namespace hexapod
