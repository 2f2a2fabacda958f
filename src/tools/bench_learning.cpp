#include "tools/bench_learning.h"

#include <atomic>
#include <deque>
#include <iomanip>
#include <locale>
#include <memory>
#include <sstream>

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

std::string describe(const std::string& preset, const std::vector<LearningSpeed>& speeds) {
  std::ostringstream rows;
  rows.imbue(std::locale::classic());
  rows << std::fixed;
  const int lanes = reduced::lanes(reduced::bestInstructionSet());
  for (const LearningSpeed& speed : speeds) {
    const double busy = static_cast<double>(speed.use.lane_steps) /
                        static_cast<double>(lanes * speed.use.register_steps);
    rows << "| " << preset << ", " << speed.threads << " | " << std::setprecision(0)
         << static_cast<double>(speed.evaluations) / speed.cpu_s << " | "
         << static_cast<double>(speed.simulations) / speed.cpu_s << " | " << std::setprecision(1)
         << 100.0 * busy << " % | " << std::setprecision(2) << speed.cpu_s / speed.wall_s << " | "
         << speeds.front().wall_s / speed.wall_s << " |\n";
  }
  return rows.str();
}

}  // namespace hexapod
