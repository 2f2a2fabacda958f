#pragma once

#include <actionlib/server/action_server_base.h>
#include <ros/callback_queue_interface.h>
#include <ros/console.h>
#include <ros/node_handle.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "ros_interface/common/cancel_memory.h"

namespace hexapod {

/// So many goals, cancels or results of an action may wait on one side of the wire. roscpp drops
/// the oldest of more, and a goal that was dropped is never answered.
constexpr std::uint32_t kActionQueueSize = 10'000;

/// An action server on the wire of actionlib (topics goal, cancel, status, feedback, result) that
/// keeps its word where actionlib's own does not:
/// - its callbacks run in the queue it is given, its status goes out on steady time;
/// - in a burst of up to kActionQueueSize goals and as many cancels every goal is answered, however
///   busy this node or the client is; the status, which names every goal, is told ten times a
///   second at most then, not once or twice per goal;
/// - a goal whose cancel overtook it on the way ends PREEMPTED with the result `cancelled_early`,
///   not RECALLED with an empty result, whose code 0 reads as success;
/// - a goal that was sent before all were cancelled, and comes just after that, is cancelled, too,
///   except in simulated time (CancelMemory);
/// - a cancel is stamped no later than it came, and one that was stamped before the clock was set
///   back cancels no later goals;
/// - a goal or cancel with an id of more than kLongestId characters is left out, with a warning:
///   every status repeats the ids;
/// - how a goal ended stays in the status for 5 s of steady time: a clock that is set makes no
///   client lose its goal, one that stands makes no list grow.
/// Destroyed by one thread after the last goal has ended; else from any thread.
template <class Action>
class SteadyActionServer : public actionlib::ActionServerBase<Action> {
 public:
  using Base = actionlib::ActionServerBase<Action>;
  using GoalHandle = typename Base::GoalHandle;
  using Result = typename Base::Result;
  using Feedback = typename Base::Feedback;
  using ActionGoal = typename Base::ActionGoal;
  using OnGoal = boost::function<void(GoalHandle)>;

  SteadyActionServer(const ros::NodeHandle& node, const std::string& name,
                     ros::CallbackQueueInterface& queue, const OnGoal& on_goal,
                     const OnGoal& on_cancel, Result cancelled_early)
      : Base(on_goal, on_cancel, false),
        node_(node, name),
        cancelled_early_(std::move(cancelled_early)) {
    node_.setCallbackQueue(&queue);
  }

 private:
  using Status = actionlib_msgs::GoalStatus;
  using Tracker = actionlib::StatusTracker<Action>;

  static constexpr std::uint32_t kFeedbackQueueSize = 50;
  static constexpr double kStatusPeriod_s = 0.2;
  static constexpr double kLeastStatusPeriod_s = 0.1;  // of a status that changes
  static constexpr double kKeepEnded_s = 5.0;
  static constexpr std::size_t kLongestId = 1000;

  void initialize() override {
    result_publisher_ =
        node_.template advertise<typename Base::ActionResult>("result", kActionQueueSize);
    feedback_publisher_ =
        node_.template advertise<typename Base::ActionFeedback>("feedback", kFeedbackQueueSize);
    status_publisher_ =
        node_.template advertise<actionlib_msgs::GoalStatusArray>("status", 1, true);
    timer_ = node_.createSteadyTimer(ros::WallDuration(kLeastStatusPeriod_s),
                                     [this](const ros::SteadyTimerEvent&) { publishDueStatus(); });
    goal_subscriber_ = node_.subscribe("goal", kActionQueueSize, &SteadyActionServer::onGoal, this);
    cancel_subscriber_ =
        node_.subscribe("cancel", kActionQueueSize, &SteadyActionServer::onCancel, this);
  }

  bool isTooLong(const std::string& id) const {
    if (id.size() <= kLongestId) return false;
    ROS_WARN_STREAM("A message on " << node_.getNamespace() << " is ignored: its goal id has "
                                    << id.size() << " characters; expected " << kLongestId
                                    << " at most.");
    return true;
  }

  void onGoal(const boost::shared_ptr<const ActionGoal>& goal) {
    if (isTooLong(goal->goal_id.id)) return;
    {
      const boost::recursive_mutex::scoped_lock lock(this->lock_);
      if (this->last_cancel_ > ros::Time::now()) this->last_cancel_ = ros::Time();
      const ros::Time& sent = goal->goal_id.stamp;
      if (cancels_.covers(sent, steadyNow_ns())) {
        this->last_cancel_ = std::max(this->last_cancel_, sent);
      }
    }
    this->goalCallback(goal);
  }

  void onCancel(const boost::shared_ptr<const actionlib_msgs::GoalID>& id) {
    if (isTooLong(id->id)) return;
    if (id->id.empty() && id->stamp.isZero() && !ros::Time::isSimTime()) {
      cancels_.cancelAll(ros::Time::now(), steadyNow_ns());
    }
    const auto present = boost::make_shared<actionlib_msgs::GoalID>(*id);
    present->stamp = std::min(id->stamp, ros::Time::now());
    this->cancelCallback(present);
  }

  void publishResult(const Status& status, const Result& result) override {
    const boost::recursive_mutex::scoped_lock lock(this->lock_);
    typename Base::ActionResult message;
    message.header.stamp = ros::Time::now();
    message.status = status;
    message.result = result;
    // This server accepts before it cancels, so only actionlib itself recalls.
    if (status.status == Status::RECALLED) {
      message.status.status = Status::PREEMPTED;
      message.result = cancelled_early_;
      for (Tracker& tracker : this->status_list_) {
        if (tracker.status_.goal_id.id == status.goal_id.id) {
          tracker.status_.status = Status::PREEMPTED;
        }
      }
    }
    result_publisher_.publish(message);
    publishStatus();
  }

  void publishFeedback(const Status& status, const Feedback& feedback) override {
    const boost::recursive_mutex::scoped_lock lock(this->lock_);
    typename Base::ActionFeedback message;
    message.header.stamp = ros::Time::now();
    message.status = status;
    message.feedback = feedback;
    feedback_publisher_.publish(message);
  }

  // At every change; those that come too close to one another are told together.
  void publishStatus() override {
    const boost::recursive_mutex::scoped_lock lock(this->lock_);
    status_changed_ = true;
    if (statusAge_s() >= kLeastStatusPeriod_s) tellStatus();
  }

  void publishDueStatus() {
    const boost::recursive_mutex::scoped_lock lock(this->lock_);
    if (status_changed_ || statusAge_s() >= kStatusPeriod_s) tellStatus();
  }

  double statusAge_s() const { return (ros::SteadyTime::now() - status_told_).toSec(); }

  void tellStatus() {
    status_told_ = ros::SteadyTime::now();
    status_changed_ = false;
    actionlib_msgs::GoalStatusArray message;
    message.header.stamp = ros::Time::now();
    for (const Tracker& tracker : this->status_list_)
      message.status_list.push_back(tracker.status_);
    status_publisher_.publish(message);
    forgetEnded();
  }

  // A goal somebody still holds a handle of is not forgotten.
  void forgetEnded() {
    const ros::SteadyTime now = ros::SteadyTime::now();
    for (auto tracker = this->status_list_.begin(); tracker != this->status_list_.end();) {
      const std::string id = tracker->status_.goal_id.id;
      if (!tracker->handle_tracker_.expired()) {
        over_since_.erase(id);
        ++tracker;
        continue;
      }
      const ros::SteadyTime since = over_since_.emplace(id, now).first->second;
      if ((now - since).toSec() <= kKeepEnded_s) {
        ++tracker;
        continue;
      }
      tracker = this->status_list_.erase(tracker);
      over_since_.erase(id);
    }
  }

  ros::NodeHandle node_;
  Result cancelled_early_;
  CancelMemory cancels_;
  std::map<std::string, ros::SteadyTime> over_since_;  // by goal id; guarded by lock_
  ros::SteadyTime status_told_;                        // guarded by lock_
  bool status_changed_ = false;                        // guarded by lock_
  ros::Publisher status_publisher_;
  ros::Publisher result_publisher_;
  ros::Publisher feedback_publisher_;
  ros::SteadyTimer timer_;
  ros::Subscriber goal_subscriber_;
  ros::Subscriber cancel_subscriber_;
};

}  // namespace hexapod
