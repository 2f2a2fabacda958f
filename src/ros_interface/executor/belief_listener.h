#pragma once

#include <ros/callback_queue.h>
#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include <atomic>
#include <mutex>
#include <string>
#include <thread>

#include "execution/belief_judge.h"
#include "execution/shared_executor.h"
#include "hexapod_repertoire/BodyBelief.h"
#include "ros_interface/common/clock.h"

namespace hexapod {

/// Has the executor tolerate the joints that body_belief tells to be dead, as far as a BeliefJudge
/// lets it. A queue and a thread of its own: what it asks for waits for the command loop.
class BeliefListener {
 public:
  /// The references must outlive it. With max_dead_legs 0 nothing is listened to. Throws as
  /// BeliefJudge does.
  BeliefListener(const ros::NodeHandle& node, SharedExecutor& executor,
                 const RobotDescription& robot, const ExecutorOptions& options, const Clock& clock);
  ~BeliefListener();
  BeliefListener(const BeliefListener&) = delete;
  BeliefListener& operator=(const BeliefListener&) = delete;

  /// Why what is told is left out; empty when it is not. From any thread.
  std::string problem() const;

 private:
  using Event = ros::MessageEvent<const hexapod_repertoire::BodyBelief>;

  void run();
  void onBelief(const Event& event);
  void apply();

  SharedExecutor& executor_;
  const Clock& clock_;
  BeliefJudge judge_;       // its thread
  JointTolerance applied_;  // its thread
  mutable std::mutex mutex_;
  std::string problem_;  // guarded by mutex_
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::Subscriber subscriber_;
  std::atomic<bool> running_{true};
  std::thread thread_;
};

}  // namespace hexapod
