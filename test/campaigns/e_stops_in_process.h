#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <thread>

#include "e_stop_tally.h"
#include "execution/shared_executor.h"
#include "gait/random_genome.h"

namespace hexapod {

/// Part 1: a loop thread, a sending thread, and the caller who stops.
class InProcess {
 public:
  InProcess(const RobotDescription& robot, std::uint64_t seed)
      : robot_(robot),
        random_(seed),
        executor_(robot, BehaviorOptions(), options()),
        pose_(robot.neutralPose()),
        loop_([this] { tick(); }),
        sender_([this] { send(); }) {}
  ~InProcess() {
    running_ = false;
    executor_.stopSending();
    loop_.join();
    sender_.join();
  }

  Tally run(int stops) {
    Tally tally;
    for (; tally.stops < stops; ++tally.stops) {
      waitFor([this] {
        executor_.arm();
        const bool sent = !armed_anew_;  // and so the first command after arming was judged
        return sent && executor_.status().mode == ExecutorMode::kReady;
      });
      const Behavior behavior(robot_, randomGenome(random_, robot_.geneCount()), {});
      limit_ = slot_.load();  // the loop stands, so that the walk is as long as was drawn
      waitFor([&] { return executor_.start(behavior, 1).accepted(); });
      limit_ = slot_ + 1 + static_cast<std::int64_t>(random_.below(130));
      waitFor([this] { return slot_ >= limit_; });
      if (executor_.status().mode == ExecutorMode::kWalking) ++tally.walking;
      stopOnce(tally);
      waitFor([this] { return executor_.status().mode == ExecutorMode::kStopped; });
    }
    tally.old_after_arm = jumps_;
    return tally;
  }

 private:
  static ExecutorOptions options() {
    ExecutorOptions options;
    options.ramp_time_s = 0.1;
    return options;
  }

  void stopOnce(Tally& tally) {
    const std::int64_t pressed = slot_;
    limit_ = kForever;  // the loop goes on while the stop comes
    executor_.setEStop(true);
    const std::uint64_t sent = sent_;
    const std::int64_t last_sent = last_sent_slot_;
    waitFor([&] { return slot_ >= pressed + 5; });
    if (sent_ != sent) ++tally.late;
    tally.latest_periods = std::max(tally.latest_periods, last_sent - pressed);
    executor_.setEStop(false);
    armed_anew_ = true;
  }

  void tick() {
    JointReadings readings(robot_.jointCount());
    while (running_) {
      if (slot_ >= limit_) {
        executor_.serve();
        std::this_thread::yield();
        continue;
      }
      {
        const std::lock_guard<std::mutex> lock(mutex_);
        readings.angles_rad = pose_;
      }
      for (std::uint64_t& count : readings.counts) ++count;
      executor_.feedback(readings);
      executor_.tick(slot_ + 1, 0);
      ++slot_;
      // A period is long enough to send in, nearly always.
      for (int i = 0; i < 1000 && last_sent_slot_ < slot_ && sendsCommands(executor_.modeInLoop());
           ++i)
        std::this_thread::yield();
    }
  }

  // The robot follows at once. The first command after arming leads from where it stands to
  // neutral.
  void send() {
    const SharedExecutor::Send send = [this](const OutgoingCommand& command) {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (armed_anew_.exchange(false) &&
          !onTheWay(pose_, robot_.neutralPose(), command.angles_rad)) {
        ++jumps_;
      }
      pose_ = command.angles_rad;
      last_sent_slot_ = command.slot;
      ++sent_;
    };
    while (executor_.sendNext(send)) {
    }
  }

  static void waitFor(const std::function<bool()>& condition) {
    while (!condition()) std::this_thread::yield();
  }

  const RobotDescription& robot_;
  Random random_;
  SharedExecutor executor_;
  std::mutex mutex_;
  std::vector<double> pose_;  // guarded by mutex_
  std::atomic<std::int64_t> slot_{0};
  std::atomic<std::int64_t> limit_{kForever};  // the loop stands at this slot
  std::atomic<std::int64_t> last_sent_slot_{0};
  std::atomic<std::uint64_t> sent_{0};
  std::atomic<bool> armed_anew_{false};
  std::atomic<int> jumps_{0};
  std::atomic<bool> running_{true};
  std::thread loop_;
  std::thread sender_;
};

}  // namespace hexapod
