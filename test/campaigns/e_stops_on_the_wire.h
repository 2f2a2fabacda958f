#pragma once

#include <hexapod_repertoire/ExecuteBehaviorActionGoal.h>
#include <hexapod_repertoire/ExecutorState.h>
#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "e_stop_tally.h"
#include "gait/random_genome.h"
#include "robot/robot_description.h"
#include "ros_session.h"

namespace hexapod {

constexpr useconds_t kLongestStall_us = 60'000;

// --- the stalled driver, a process of its own ---

// Obeys a set-point at the beginning of a callback and tells so, then stalls for some periods.
inline int driveStalled() {
  RosSession::join("stalled_driver");
  ros::NodeHandle node;
  beOnTime();
  Random random(7);
  const ros::Publisher obeyed = node.advertise<sensor_msgs::JointState>("obeyed", 1000);
  const auto subscriber = node.subscribe<sensor_msgs::JointState>(
      "joint_command", 1,
      boost::function<void(const sensor_msgs::JointState::ConstPtr&)>(
          [&](const sensor_msgs::JointState::ConstPtr& command) {
            sensor_msgs::JointState told = *command;
            told.velocity.assign(1, 1e-9 * static_cast<double>(steadyNow_ns()));
            obeyed.publish(told);
            usleep(kLongestStall_us / 3 +
                   static_cast<useconds_t>(random.below(2 * kLongestStall_us / 3)));
          }),
      ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  ros::spin();
  return 0;
}

/// Part 2: this process is the clock, the robot, the client and the witness.
class OnTheWire {
 public:
  OnTheWire(const RobotDescription& robot, double speed, std::uint64_t seed)
      : robot_(robot), random_(seed), speed_(speed), spinner_(2) {
    ros::param::set("/use_sim_time", true);
    ros::param::set("/executor/ramp_time_s", 0.1);
    ros::param::set("/executor/hold_time_s", 0.0);
    clock_publisher_ = node_.advertise<rosgraph_msgs::Clock>("/clock", 1);
    states_publisher_ = node_.advertise<sensor_msgs::JointState>("joint_states", 1);
    e_stop_ = node_.advertise<std_msgs::Bool>("e_stop", 1);
    goals_ = node_.advertise<hexapod_repertoire::ExecuteBehaviorActionGoal>("execute/goal", 1);
    pose_ = robot.neutralPose();
    commands_ = subscribe("joint_command", [this](const auto& command) { onCommand(command); });
    obeyed_ = subscribe("obeyed", [this](const auto& command) { onObeyed(command); });
    state_subscriber_ = node_.subscribe<hexapod_repertoire::ExecutorState>(
        "executor/state", 10,
        boost::function<void(const hexapod_repertoire::ExecutorState::ConstPtr&)>(
            [this](const hexapod_repertoire::ExecutorState::ConstPtr& s) { state_ = s->state; }));
    clock_ = std::thread([this] { passTime(); });
    spinner_.start();
    executor_ = RosSession::start("executor");
    driver_ = std::make_unique<Child>(
        std::vector<std::string>{binariesFolder() + "/campaign_e_stops", "--driver"});
  }
  ~OnTheWire() {
    running_ = false;
    clock_.join();
    spinner_.stop();
  }

  Tally run(int stops) {
    for (; tally_.stops < stops; ++tally_.stops) {
      arm();
      walk();
      waitUntil(now_ns_ + static_cast<std::int64_t>(random_.below(3'900'000'000)));
      if (state_ == hexapod_repertoire::ExecutorState::WALKING) ++tally_.walking;
      stopOnce();
    }
    tally_.old_after_arm = old_after_arm_;
    tally_.latest_periods = latest_ns_ / kPeriod_ns;
    return tally_;
  }

  int oldSetPointsObeyedAfterStops() const { return obeyed_after_stop_; }
  int mostAfterOneStop() const { return most_after_one_stop_; }
  int stopsWithMoreThanOne() const { return more_than_one_; }
  int armedAgain() const { return armed_again_; }

 private:
  using Command = sensor_msgs::JointState::ConstPtr;

  ros::Subscriber subscribe(const std::string& topic,
                            const std::function<void(const Command&)>& f) {
    return node_.subscribe<sensor_msgs::JointState>(
        topic, 1000, boost::function<void(const Command&)>(f), ros::VoidConstPtr(),
        ros::TransportHints().tcpNoDelay());
  }

  // 1 kHz of real time; joint states every 10 ms of simulated time.
  void passTime() {
    const std::int64_t step_ns = static_cast<std::int64_t>(1e6 * speed_);
    sensor_msgs::JointState states;
    states.name = robot_.jointNames();
    std::int64_t next_states_ns = 0;
    for (std::int64_t deadline_ns = steadyNow_ns(); running_; deadline_ns += 1'000'000) {
      sleepUntilSteady(deadline_ns);
      deadline_ns = std::max(deadline_ns, steadyNow_ns() - 2'000'000);
      now_ns_ += step_ns;
      rosgraph_msgs::Clock clock;
      clock.clock = timeFromNs(now_ns_);
      clock_publisher_.publish(clock);
      if (now_ns_ < next_states_ns) continue;
      next_states_ns = now_ns_ + 10'000'000;
      states.header.stamp = clock.clock;
      {
        const std::lock_guard<std::mutex> lock(mutex_);
        states.position = pose_;
      }
      states_publisher_.publish(states);
    }
  }

  void onCommand(const Command& command) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::int64_t stamp_ns = toNs(command->header.stamp);
    if (stopped_) {
      last_stamp_ns_ = stamp_ns;
    } else if (first_after_arm_) {
      first_after_arm_ = false;
      if (!onTheWay(pose_, robot_.neutralPose(), command->position)) ++old_after_arm_;
    }
    if (!stopped_) pose_ = command->position;
  }

  void onObeyed(const Command& command) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const double obeyed_s = command->velocity.at(0);  // when the driver did, steady time
    if (stopped_ && obeyed_s > taken_s_ + period_s_) ++obeyed_this_stop_;
    // Nothing is sent between a period after the stop and the next arming.
    const bool old = toNs(command->header.stamp) <= taken_ns_ + kPeriod_ns;
    if (!stopped_ && old && obeyed_s > armed_s_) ++old_after_arm_;
  }

  // Until it stands; where feedback comes too late for that, more than once.
  void arm() {
    using State = hexapod_repertoire::ExecutorState;
    while (state_ != State::READY) {
      {
        const std::lock_guard<std::mutex> lock(mutex_);
        armed_s_ = steadyNow_s();
        stopped_ = false;
        first_after_arm_ = true;
      }
      std_srvs::Trigger trigger;
      ros::service::call("/executor/arm", trigger);
      const std::int64_t deadline_ns = now_ns_ + 3'000'000'000;
      while (state_ != State::READY && state_ != State::FAULT && now_ns_ < deadline_ns) usleep(500);
      if (state_ == State::READY) break;
      ++armed_again_;
      usleep(20'000);
    }
  }

  void walk() {
    hexapod_repertoire::ExecuteBehaviorActionGoal goal;
    goal.goal_id.id = std::to_string(tally_.stops + 1);
    goal.goal.entry_id = -1;
    goal.goal.genome = randomGenome(random_, robot_.geneCount());
    while (goals_.getNumSubscribers() == 0) usleep(1000);
    goals_.publish(goal);
  }

  void noteStop() {
    const std::lock_guard<std::mutex> lock(mutex_);
    taken_ns_ = now_ns_;
    taken_s_ = steadyNow_s();
    stopped_ = true;
    obeyed_this_stop_ = 0;
  }

  // Half of the stops by topic, half by service: that is a stop when it has answered, whatever time
  // looking it up and connecting to it takes.
  void stopOnce() {
    std_msgs::Bool pressed;
    pressed.data = true;
    std_srvs::Trigger trigger;
    const bool by_topic = random_.chance(0.5);
    if (!by_topic) ros::service::call("/executor/stop", trigger);
    noteStop();
    if (by_topic) e_stop_.publish(pressed);
    waitFor(hexapod_repertoire::ExecutorState::STOPPED);
    waitUntil(now_ns_ + 10 * kPeriod_ns);
    usleep(kLongestStall_us);  // armed again no sooner than the driver is done with its queue
    pressed.data = false;
    if (by_topic) e_stop_.publish(pressed);
    const std::lock_guard<std::mutex> lock(mutex_);
    latest_ns_ = std::max(latest_ns_, last_stamp_ns_ - taken_ns_);
    if (last_stamp_ns_ > taken_ns_ + kPeriod_ns) ++tally_.late;
    obeyed_after_stop_ += obeyed_this_stop_;
    if (obeyed_this_stop_ > 1) ++more_than_one_;
    most_after_one_stop_ = std::max(most_after_one_stop_, obeyed_this_stop_);
  }

  void waitFor(int state) const {
    while (state_ != state) usleep(500);
  }
  void waitUntil(std::int64_t time_ns) const {
    while (now_ns_ < time_ns) usleep(500);
  }

  const RobotDescription& robot_;
  Random random_;
  double speed_;
  ros::NodeHandle node_;
  ros::AsyncSpinner spinner_;
  ros::Publisher clock_publisher_, states_publisher_, e_stop_, goals_;
  ros::Subscriber commands_, obeyed_, state_subscriber_;
  std::unique_ptr<Child> executor_, driver_;
  std::atomic<bool> running_{true};
  std::atomic<int> state_{-1};
  std::atomic<std::int64_t> now_ns_{1'000'000'000};
  std::thread clock_;
  std::mutex mutex_;  // all below
  std::vector<double> pose_;
  bool stopped_ = true;
  bool first_after_arm_ = false;
  std::int64_t taken_ns_ = 0, last_stamp_ns_ = 0, latest_ns_ = 0;
  double taken_s_ = 0, armed_s_ = 0;  // steady time
  double period_s_ = 1e-9 * kPeriod_ns / speed_;
  int old_after_arm_ = 0;
  int armed_again_ = 0;  // armings that did not end in READY
  int obeyed_this_stop_ = 0, obeyed_after_stop_ = 0, most_after_one_stop_ = 0, more_than_one_ = 0;
  Tally tally_;
};

}  // namespace hexapod
