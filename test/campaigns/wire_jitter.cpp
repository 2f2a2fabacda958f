// Ticks at a subscriber: how punctual commands arrive, idle and on a busy machine, beside a plain
// loop.
//
//   --short      some seconds; nothing is asserted about times
//   --ticks N    commands to watch in each part, 20,000 by default
#include <hexapod_repertoire/ExecuteBehaviorActionGoal.h>
#include <sensor_msgs/JointState.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <mutex>

#include "common/random.h"
#include "ros_interface/common/clock.h"
#include "ros_session.h"

namespace hexapod {
namespace {

constexpr std::int64_t kPeriod_ns = 30'000'000;
constexpr std::size_t kJoints = 18;
constexpr double kAllowed_ms = 0.5;   // above the plain loop's 99.9th percentile
constexpr double kBunched_ms = 15.0;  // two commands nearer than half a period

sensor_msgs::JointState message() {
  sensor_msgs::JointState message;
  message.name.assign(kJoints, "joint_name_like");
  message.position.assign(kJoints, 0.0);
  return message;
}

// --- what the children do ---

// The loop everybody writes: absolute deadlines, publish, nothing else; but with a real-time
// priority, as the executor has.
void plainLoop() {
  beOnTime();
  ros::NodeHandle node;
  ros::Publisher publisher = node.advertise<sensor_msgs::JointState>("plain_command", 1);
  sensor_msgs::JointState command = message();
  for (std::int64_t deadline_ns = steadyNow_ns();; deadline_ns += kPeriod_ns) {
    sleepUntilSteady(deadline_ns);
    command.header.stamp = timeFromNs(deadline_ns);
    publisher.publish(command);
  }
}

void sendTraffic() {
  ros::NodeHandle node;
  ros::Publisher publisher = node.advertise<sensor_msgs::JointState>("traffic", 10);
  for (std::int64_t deadline_ns = steadyNow_ns();; deadline_ns += 1'000'000) {
    sleepUntilSteady(deadline_ns);
    publisher.publish(message());
  }
}

void listenToTraffic() {
  ros::NodeHandle node;
  const auto subscriber = node.subscribe<sensor_msgs::JointState>(
      "traffic", 10,
      boost::function<void(const sensor_msgs::JointState::ConstPtr&)>(
          [](const sensor_msgs::JointState::ConstPtr&) {}));
  ros::spin();
}

void burn() {
  volatile double number = 1.0;
  for (;;) number = std::sqrt(number + 1.0);
}

void writeToDisk() {
  const std::vector<char> block(4 << 20, 'x');
  FILE* file = std::tmpfile();
  while (file != nullptr) {
    std::rewind(file);
    std::fwrite(block.data(), 1, block.size(), file);
    std::fflush(file);
    fsync(fileno(file));
  }
}

int playRole(const std::string& role) {
  if (role == "burn") burn();
  if (role == "disk") writeToDisk();
  RosSession::join("wire_jitter_" + role);
  if (role == "plain") plainLoop();
  if (role == "traffic") sendTraffic();
  if (role == "listener") listenToTraffic();
  return 1;
}

// --- what is measured ---

/// Arrivals on one topic, on a thread of their own.
class Probe {
 public:
  explicit Probe(const std::string& topic) : spinner_(1, &queue_) {
    node_.setCallbackQueue(&queue_);
    subscriber_ = node_.subscribe<sensor_msgs::JointState>(
        topic, 1000,
        boost::function<void(const sensor_msgs::JointState::ConstPtr&)>(
            [this](const sensor_msgs::JointState::ConstPtr& command) {
              thread_local const bool on_time = (beOnTime(), true);
              static_cast<void>(on_time);
              const std::int64_t now_ns = steadyNow_ns();
              const std::lock_guard<std::mutex> lock(mutex_);
              arrivals_.push_back({now_ns, toNs(command->header.stamp)});
            }),
        ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
    spinner_.start();
  }

  struct Arrival {
    std::int64_t steady_ns, stamp_ns;
  };

  std::size_t count() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return arrivals_.size();
  }
  std::vector<Arrival> take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::move(arrivals_);
  }
  void clear() {
    const std::lock_guard<std::mutex> lock(mutex_);
    arrivals_.clear();
  }

 private:
  mutable std::mutex mutex_;
  std::vector<Arrival> arrivals_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::Subscriber subscriber_;
  ros::AsyncSpinner spinner_;
};

struct Figures {
  std::size_t ticks = 0;
  std::int64_t skipped = 0;
  std::size_t bunched = 0;
  std::size_t disordered = 0;  // stamps that are no whole periods after the one before
  double mean_ms = 0, median_ms = 0, p99_ms = 0, p999_ms = 0, largest_ms = 0;
};

Figures figuresOf(const std::vector<Probe::Arrival>& arrivals) {
  Figures figures;
  std::vector<double> intervals_ms;
  for (std::size_t i = 1; i < arrivals.size(); ++i) {
    const std::int64_t stamps_ns = arrivals[i].stamp_ns - arrivals[i - 1].stamp_ns;
    if (stamps_ns <= 0 || stamps_ns % kPeriod_ns != 0) ++figures.disordered;
    figures.skipped += std::max<std::int64_t>(0, stamps_ns / kPeriod_ns - 1);
    const double interval_ms =
        1e-6 * static_cast<double>(arrivals[i].steady_ns - arrivals[i - 1].steady_ns);
    if (interval_ms < kBunched_ms) ++figures.bunched;
    intervals_ms.push_back(interval_ms);
  }
  if (intervals_ms.empty()) return figures;
  figures.ticks = arrivals.size();
  const double span_ms =
      1e-6 * static_cast<double>(arrivals.back().steady_ns - arrivals.front().steady_ns);
  figures.mean_ms = span_ms / static_cast<double>(intervals_ms.size() +
                                                  static_cast<std::size_t>(figures.skipped));
  std::sort(intervals_ms.begin(), intervals_ms.end());
  const auto quantile = [&](double share) {
    return intervals_ms[static_cast<std::size_t>(share *
                                                 static_cast<double>(intervals_ms.size() - 1))];
  };
  figures.median_ms = quantile(0.5);
  figures.p99_ms = quantile(0.99);
  figures.p999_ms = quantile(0.999);
  figures.largest_ms = intervals_ms.back();
  return figures;
}

void print(const char* part, const char* loop, const Figures& figures) {
  std::printf("| %s | %s | %zu | %.3f | %.2f | %.2f | %.2f | %.2f | %zu | %lld |\n", part, loop,
              figures.ticks, figures.mean_ms, figures.median_ms, figures.p99_ms, figures.p999_ms,
              figures.largest_ms, figures.bunched, static_cast<long long>(figures.skipped));
  std::fflush(stdout);
}

/// Walks without a pause, so that the commands watched are those of behaviours.
class Walking {
 public:
  Walking()
      : publisher_(ros::NodeHandle().advertise<hexapod_repertoire::ExecuteBehaviorActionGoal>(
            "execute/goal", 1)) {}

  void poll() {
    if (steadyNow_ns() < next_ns_) return;
    next_ns_ = steadyNow_ns() + 4'200'000'000;  // a behaviour takes 3.9 s
    hexapod_repertoire::ExecuteBehaviorActionGoal goal;
    goal.goal_id.id = std::to_string(next_ns_);
    goal.goal.entry_id = -1;
    for (int gene = 0; gene < 24; ++gene) {
      goal.goal.genome.push_back(static_cast<std::uint8_t>(random_.below(5)));
    }
    publisher_.publish(goal);
  }

 private:
  ros::Publisher publisher_;
  std::int64_t next_ns_ = 0;
  Random random_{1};
};

class Campaign {
 public:
  Campaign(std::size_t ticks, bool judge_times) : ticks_(ticks), judge_times_(judge_times) {}

  bool run() {
    ros::param::set("/executor/feedback_timeout_s", 0.0);
    ros::param::set("/executor/auto_arm", true);
    const auto executor = RosSession::start("executor");
    const auto plain = role("plain");
    std::printf(
        "Intervals between the arrivals of two commands at a subscriber [ms]. Bunched: nearer than "
        "%.0f ms.\nThe mean counts skipped commands as sent. Both loops have a real-time priority. "
        "Seed of the "
        "gaits: 1.\n\n"
        "| machine | loop | ticks | mean | median | p99 | p99.9 | largest | bunched | skipped |\n"
        "|---|---|---|---|---|---|---|---|---|---|\n",
        kBunched_ms);
    part("idle");
    {
      std::vector<std::unique_ptr<Child>> load;
      for (const char* name : {"burn", "burn", "disk", "listener", "traffic"}) {
        load.push_back(role(name));
      }
      part("busy: both cores, disk, 1,000 messages/s");
    }
    std::printf("\n%s\n", good_ ? "All promises held." : "Not all promises held.");
    return good_;
  }

 private:
  static std::unique_ptr<Child> role(const std::string& name) {
    return std::make_unique<Child>(
        std::vector<std::string>{binariesFolder() + "/campaign_wire_jitter", "--role", name});
  }

  void part(const char* name) {
    watch(20);  // until everything is connected and loaded
    executor_.clear();
    plain_.clear();
    watch(ticks_);
    const Figures ours = figuresOf(executor_.take());
    const Figures theirs = figuresOf(plain_.take());
    print(name, "executor", ours);
    print(name, "plain", theirs);
    expect(ours.disordered == 0 && theirs.disordered == 0, "stamps are whole periods apart");
    if (!judge_times_) return;
    expect(std::abs(ours.mean_ms - 30.0) < 0.005, "the mean is 30.00 ms");
    expect(ours.bunched <= theirs.bunched, "no more bunching than in the plain loop");
    expect(ours.p999_ms <= theirs.p999_ms + kAllowed_ms, "p99.9 at most the plain loop's + 0.5 ms");
  }

  void watch(std::size_t ticks) {
    const std::size_t target = executor_.count() + ticks;
    while (executor_.count() < target) {
      walking_.poll();
      usleep(10'000);
    }
  }

  void expect(bool held, const char* promise) {
    if (held) return;
    good_ = false;
    std::fprintf(stderr, "Broken: %s.\n", promise);
  }

  std::size_t ticks_;
  bool judge_times_;
  bool good_ = true;
  Probe executor_{"joint_command"};
  Probe plain_{"plain_command"};
  Walking walking_;
};

int runCampaign(int argc, char** argv) {
  std::size_t ticks = 20'000;
  bool judge_times = true;
  for (int i = 1; i < argc; ++i) {
    const bool value = i + 1 < argc;
    if (std::strcmp(argv[i], "--role") == 0 && value) return playRole(argv[i + 1]);
    if (std::strcmp(argv[i], "--short") == 0) {
      ticks = 100;
      judge_times = false;
    } else if (std::strcmp(argv[i], "--ticks") == 0 && value) {
      ticks = std::stoul(argv[++i]);
    } else {
      std::fprintf(stderr, "usage: %s [--short] [--ticks N]\n", argv[0]);
      return 2;
    }
  }
  RosSession session("wire_jitter");
  return Campaign(ticks, judge_times).run() ? 0 : 1;
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) { return hexapod::runCampaign(argc, argv); }
