#include <gtest/gtest.h>

#include <memory>

#include "execution/executor_core.h"
#include "gait/random_genome.h"
#include "shipped_robot.h"

namespace hexapod {
namespace {

// Random sequences of events, stalls, noise on the feedback and illegal commands. Whatever happens,
// what is sent keeps the contract of the wire.
class RandomSession {
 public:
  explicit RandomSession(std::uint64_t seed)
      : random_(seed), open_loop_(random_.chance(0.3)), core_(robot_, {}, options()) {
    for (int i = 0; i < 3; ++i) behaviors_.emplace_back(robot_, randomGenome(random_), behavior_);
  }

  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      if (random_.chance(0.1)) event();
      if (random_.chance(0.95)) feedback();
      slot_ += random_.chance(0.02) ? 1 + static_cast<std::int64_t>(random_.below(40)) : 1;
      const ExecutorMode before = core_.status().mode;
      const std::vector<double>* command = core_.tick(slot_);
      if (command == nullptr) {
        expectSilence(before);
      } else {
        check(*command);
      }
    }
  }

  int sent() const { return sent_; }
  std::uint64_t behaviorsPlayed() const { return core_.status().serial; }

 private:
  ExecutorOptions options() {
    ExecutorOptions options;
    if (open_loop_) options.feedback_timeout_s = 0.0;
    options.ramp_time_s = random_.uniform(0.1, 1.0);
    options.hold_time_s = random_.uniform(0.0, 0.3);
    return options;
  }

  void event() {
    switch (random_.below(10)) {
      case 0:
      case 1:
      case 2:
        if (core_.arm().accepted()) armed();
        break;
      case 3:
      case 4:
      case 5:
        core_.start(behaviors_[random_.below(behaviors_.size())], 1);
        break;
      case 6:
        core_.cancel(Reason::kCancelled);
        break;
      case 7:
        random_.chance(0.5) ? core_.sit() : core_.disarm();
        break;
      case 8:
        if (random_.chance(0.3)) core_.stop(Reason::kStopRequested), silent_ = true;
        break;
      case 9:
        e_stop_ = random_.chance(0.1);
        core_.setEStop(e_stop_);
        silent_ = silent_ || e_stop_;
        break;
    }
  }

  void feedback() {
    core_.feedback(driver_.read(measured_));
    fed_ = measured_;
  }

  // From here the next command must be near: the pose it was told, or open loop the last command.
  void armed() {
    silent_ = false;
    if (open_loop_) return;
    const std::vector<const Joint*> joints = robot_.joints();
    for (std::size_t j = 0; j < joints.size(); ++j) {
      last_[j] = std::clamp(fed_[j], joints[j]->lower_rad, joints[j]->upper_rad);
    }
  }

  void expectSilence(ExecutorMode before) {
    // Nothing sent: because nothing is to be sent, before this tick or from it on.
    EXPECT_TRUE(!sendsCommands(before) || !sendsCommands(core_.status().mode));
    disturb();
  }

  void check(const std::vector<double>& command) {
    ++sent_;
    EXPECT_FALSE(silent_) << "a stop is a stop";
    const std::vector<const Joint*> joints = robot_.joints();
    for (std::size_t j = 0; j < joints.size(); ++j) {
      EXPECT_TRUE(std::isfinite(command[j]));
      EXPECT_GE(command[j], joints[j]->lower_rad);
      EXPECT_LE(command[j], joints[j]->upper_rad);
    }
    // Continuous, also with the pose the robot was in when it was armed.
    EXPECT_LE(largestStep(command, last_), 6.28 * 0.030 * (1.0 + 1e-8));
    last_ = command;
    measured_ = command;
    for (double& angle : measured_) angle += random_.uniform(-0.1, 0.1);
  }

  // While nothing is sent somebody moves the legs, beyond their limits too.
  void disturb() {
    if (!random_.chance(0.1)) return;
    for (double& angle : measured_) angle = random_.uniform(-1.8, 1.8);
  }

  Random random_;
  bool open_loop_;
  const RobotDescription& robot_ = shippedRobot();
  BehaviorOptions behavior_;
  ExecutorCore core_;
  std::vector<Behavior> behaviors_;
  WholeRobotDriver driver_;
  std::vector<double> measured_ = robot_.neutralPose();
  std::vector<double> fed_ = measured_;
  std::vector<double> last_ = measured_;
  std::int64_t slot_ = 0;
  bool silent_ = false;
  bool e_stop_ = false;
  int sent_ = 0;
};

TEST(ExecutorCore, RandomSessionsNeverLeaveTheLimitsAndAStopIsAStop) {
  int sent = 0;
  std::uint64_t played = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    RandomSession session(seed);
    session.run(500);
    sent += session.sent();
    played += session.behaviorsPlayed();
    ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << seed;
  }
  EXPECT_GT(sent, 10000) << "the sessions are no test when they send nothing";
  EXPECT_GT(played, 200u);
}

}  // namespace
}  // namespace hexapod
