#include "tools/bench_learning.h"

#include <atomic>
#include <chrono>
#include <deque>
#include <memory>
#include <string>
#include <thread>

#include "common/text.h"
#include "learning/learning_run.h"
#include "simulation/reduced/batch_stepper.h"
#include "tools/machine.h"

namespace hexapod {

const char* const kLearningHeading =
    "| preset, threads | evaluations/s of CPU | simulations/s of CPU | lanes that have a run | CPU "
    "time per time | times 1 thread |\n"
    "|---|---|---|---|---|---|\n";

namespace {

struct Racer {
  std::unique_ptr<LearningRun> run;
  LearningSpeed speed;
};

void addCounts(const LearningRun& run, std::int64_t sign, LearningSpeed& speed) {
  speed.evaluations += sign * run.counters().evaluations;
  speed.simulations += sign * run.simulations();
}

void stepOnce(Racer& racer) {
  const double cpu_s = processCpu_s(), begin_s = wall_s();
  racer.run->step();
  racer.speed.cpu_s += processCpu_s() - cpu_s;
  racer.speed.wall_s += wall_s() - begin_s;
}

}  // namespace

std::vector<LearningSpeed> measureLearning(const RobotDescription& robot,
                                           const LearnOptions& options) {
  const std::atomic<bool> never{false};
  std::deque<Racer> racers;
  for (const int threads : {1, 2}) {
    LearnOptions own = suitedTo(robot, options);
    own.threads = threads;
    racers.push_back({std::make_unique<LearningRun>(robot, own, RunStart(), never,
                                                    DistributedEvaluator::Workers()),
                      {}});
    Racer& racer = racers.back();
    racer.speed.threads = threads;
    racer.run->step();  // builds the worlds
    addCounts(*racer.run, -1, racer.speed);
  }
  while (racers.front().run->budgetIsLeft()) {
    for (Racer& racer : racers) stepOnce(racer);
  }
  std::vector<LearningSpeed> speeds;
  for (Racer& racer : racers) {
    addCounts(*racer.run, 1, racer.speed);
    racer.speed.use = racer.run->laneUse();
    speeds.push_back(racer.speed);
  }
  return speeds;
}

double cpuOfTwoThreads(double seconds) {
  std::atomic<bool> stop{false};
  const double cpu_s = processCpu_s(), begin_s = wall_s();
  const auto keepBusy = [&] {
    while (!stop) continue;
  };
  std::thread one(keepBusy), other(keepBusy);
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  stop = true;
  one.join();
  other.join();
  return (processCpu_s() - cpu_s) / (wall_s() - begin_s);
}

std::string describe(const std::string& preset, const std::vector<LearningSpeed>& speeds) {
  std::string rows;
  const int lanes = reduced::lanes(reduced::bestInstructionSet());
  for (const LearningSpeed& speed : speeds) {
    const double busy = static_cast<double>(speed.use.lane_steps) /
                        static_cast<double>(lanes * speed.use.register_steps);
    rows += tableRow({preset + ", " + std::to_string(speed.threads),
                      fixedText(static_cast<double>(speed.evaluations) / speed.cpu_s, 0),
                      fixedText(static_cast<double>(speed.simulations) / speed.cpu_s, 0),
                      fixedText(100.0 * busy, 1) + " %", fixedText(speed.cpu_s / speed.wall_s, 2),
                      fixedText(speeds.front().wall_s / speed.wall_s, 2)});
  }
  return rows;
}

}  // namespace hexapod
