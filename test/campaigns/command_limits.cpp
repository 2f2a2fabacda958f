// Commands of random sessions: none is outside the joints' limits, by a check that shares no code.
//
// Sessions of random gaits, changes, cancels, stops, stalls and feedback, half of them with an
// acceleration limit; every command goes to joint_limit_check.py, which reads the URDF itself.
//
//   --short      some thousand commands
//   --commands N 1,000,000 by default; --seed N 1 by default
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "common/random.h"
#include "execution/executor_core.h"
#include "robot/load_robot.h"

namespace hexapod {
namespace {

constexpr double kAcceleration_rad_per_s2 = 60.0;

// What joint_limit_check.py reads, followed by one double per joint.
struct Record {
  enum Kind : std::int64_t { kSession = 0, kStart = 1, kCommand = 2 };
  std::int64_t kind;          // a session begins; the pose it starts from; a command
  std::int64_t slot;          // of a command
  double acceleration_limit;  // of a session; 0: none
};

struct Tally {
  std::uint64_t commands = 0, changes = 0, cancels = 0, stops = 0, stalls = 0, sessions = 0;
};

/// One executor and a robot that follows it, disturbed at random.
class Session {
 public:
  Session(const RobotDescription& robot, std::uint64_t seed, FILE* out, Tally& tally)
      : robot_(robot),
        random_(seed),
        out_(out),
        tally_(tally),
        options_(drawOptions()),
        core_(robot, BehaviorOptions(), options_),
        measured_(robot.neutralPose()),
        readings_(robot.jointCount()) {
    ++tally_.sessions;
    write(Record::kSession, 0, measured_);
  }

  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      if (random_.chance(0.03)) disturb();
      act();
      feed();
      ++slot_;
      if (random_.chance(0.005)) {
        slot_ += 1 + static_cast<std::int64_t>(random_.below(200));
        ++tally_.stalls;
      }
      const std::vector<double>* command = core_.tick(slot_);
      if (command != nullptr) send(*command);
    }
  }

 private:
  ExecutorOptions drawOptions() {
    ExecutorOptions options;
    if (random_.chance(0.3)) options.feedback_timeout_s = 0.0;
    options.max_tracking_error_rad = random_.chance(0.5) ? 0.5 : 0.0;
    options.ramp_time_s = random_.uniform(0.1, 1.0);
    options.hold_time_s = random_.uniform(0.0, 0.3);
    options.hold_on_stop = random_.chance(0.5);
    if (random_.chance(0.5)) options.gate.max_acceleration_rad_per_s2 = kAcceleration_rad_per_s2;
    if (random_.chance(0.3)) options.gate.soft_limit_margin_rad = random_.uniform(0.0, 0.5);
    return options;
  }

  // An executor that does nothing is no test: it is armed and given behaviours whenever it may be.
  void act() {
    if (!sendsCommands(core_.status().mode) && random_.chance(0.2)) {
      core_.setEStop(false);
      if (core_.arm().accepted()) started();
    }
    if (core_.status().mode != ExecutorMode::kReady || !random_.chance(0.5)) return;
    Genome genome(robot_.geneCount());
    for (auto& gene : genome) gene = static_cast<std::uint8_t>(random_.below(kGeneLevels));
    behavior_ = std::make_unique<Behavior>(robot_, genome, BehaviorOptions());
    if (core_.start(*behavior_, 1).accepted()) ++tally_.changes;
  }

  void disturb() {
    switch (random_.below(8)) {
      case 0:
      case 1:
      case 2:
      case 3:
        if (core_.cancel(Reason::kCancelled).accepted()) ++tally_.cancels;
        break;
      case 4:
        core_.sit();
        break;
      case 5:
        core_.disarm();
        break;
      default:
        if (sendsCommands(core_.status().mode)) ++tally_.stops;
        random_.chance(0.5) ? core_.setEStop(true) : core_.stop(Reason::kStopRequested);
    }
  }

  // While nothing is sent somebody moves the legs, beyond their limits too.
  void feed() {
    if (!sendsCommands(core_.status().mode) && random_.chance(0.1)) {
      for (double& angle : measured_) angle = random_.uniform(-1.8, 1.8);
    }
    if (!random_.chance(0.95)) return;
    readings_.angles_rad = measured_;
    for (std::uint64_t& count : readings_.counts) ++count;
    core_.feedback(readings_);
  }

  void started() {
    const bool closed_loop = options_.feedback_timeout_s > 0.0;
    write(Record::kStart, slot_, closed_loop ? readings_.angles_rad : last_);
  }

  void send(const std::vector<double>& command) {
    ++tally_.commands;
    last_ = command;
    write(Record::kCommand, slot_, command);
    for (std::size_t j = 0; j < measured_.size(); ++j) {
      measured_[j] += 0.4 * (command[j] - measured_[j]) + random_.uniform(-0.01, 0.01);
    }
  }

  void write(Record::Kind kind, std::int64_t slot, const std::vector<double>& angles_rad) {
    const Record record{kind, slot, options_.gate.max_acceleration_rad_per_s2};
    std::fwrite(&record, sizeof record, 1, out_);
    std::fwrite(angles_rad.data(), sizeof(double), angles_rad.size(), out_);
  }

  const RobotDescription& robot_;
  Random random_;
  FILE* out_;
  Tally& tally_;
  ExecutorOptions options_;
  ExecutorCore core_;
  std::unique_ptr<Behavior> behavior_;
  std::vector<double> measured_;
  JointReadings readings_;
  std::vector<double> last_ = measured_;  // command
  std::int64_t slot_ = 0;
};

int runCampaign(std::uint64_t commands, std::uint64_t seed) {
  const std::string root = HEXAPOD_ROOT;
  const RobotDescription robot =
      loadRobot(root + "/urdf/hexapod.urdf", root + "/config/hexapod.yaml");
  std::fflush(stdout);
  FILE* check = popen(("/usr/bin/python3 '" + root + "/test/execution/joint_limit_check.py' '" +
                       root + "/urdf/hexapod.urdf' " + std::to_string(robot.jointCount()))
                          .c_str(),
                      "w");
  if (check == nullptr) return 1;
  for (const std::string& name : robot.jointNames()) std::fprintf(check, "%s\n", name.c_str());
  Tally tally;
  for (std::uint64_t session = 0; tally.commands < commands; ++session) {
    Session(robot, seed * 1'000'003 + session, check, tally).run(1000);
  }
  const bool held = pclose(check) == 0;
  std::printf(
      "\n| commands | sessions | behaviours | cancels | stops | stalls | seed |\n"
      "|---|---|---|---|---|---|---|\n| %llu | %llu | %llu | %llu | %llu | %llu | %llu |\n",
      static_cast<unsigned long long>(tally.commands),
      static_cast<unsigned long long>(tally.sessions),
      static_cast<unsigned long long>(tally.changes),
      static_cast<unsigned long long>(tally.cancels), static_cast<unsigned long long>(tally.stops),
      static_cast<unsigned long long>(tally.stalls), static_cast<unsigned long long>(seed));
  return held ? 0 : 1;
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  std::uint64_t commands = 1'000'000;
  std::uint64_t seed = 1;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--short") {
      commands = 20'000;
    } else if (word == "--commands" && i + 1 < argc) {
      commands = std::stoull(argv[++i]);
    } else if (word == "--seed" && i + 1 < argc) {
      seed = std::stoull(argv[++i]);
    } else {
      std::fprintf(stderr, "usage: %s [--short] [--commands N] [--seed N]\n", argv[0]);
      return 2;
    }
  }
  return hexapod::runCampaign(commands, seed);
}
