#include "study/study_run.h"

#include <chrono>
#include <memory>

#include "common/text.h"
#include "evaluation/behavior_evaluator.h"
#include "evaluation/cached_evaluator.h"
#include "study/methods.h"
#include "study/run_files.h"
#include "study/run_recorder.h"

namespace hexapod {
namespace {

// About 200 bytes each.
constexpr std::size_t kCachedGenomes = 1000000;

class StopWatch {
 public:
  double seconds() const {
    const auto passed = std::chrono::steady_clock::now() - start_;
    return std::chrono::duration<double>(passed).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

RunResult performRun(const RobotDescription& robot, const StudyOptions& options,
                     const RunPlan& plan, const std::string& machine, const std::string& folder) {
  const StopWatch watch;
  Physics physics;
  physics.step_s = options.step_s;
  const EngineChoice engine = chooseEngine(options.engine, robot);
  BehaviorEvaluator simulator(std::make_shared<WorldPool>(engine.engine, robot, physics, 1),
                              options.behavior);
  const GenomeSpace gaits = gaitsOf(robot, options.behavior);
  CachedEvaluator evaluator(simulator, kCachedGenomes, gaits);
  const Method method =
      makeMethod(plan.algorithm, {gaits, evaluator.looks(), symmetriesOf(robot, gaits.levels)},
                 options, Random(static_cast<std::uint64_t>(plan.seed)));
  const EvolutionCounters& counters = method.algorithm->counters();
  RunRecorder recorder(folder);
  while (counters.evaluations < plan.evaluations) {
    advance(*method.algorithm, evaluator, plan.evaluations - counters.evaluations);
    recorder.record(method, simulator.counts().simulations, watch.seconds());
  }
  recorder.finish(method, simulator.counts().simulations, watch.seconds());
  if (plan.algorithm == "targets") {
    writeTargets(folder + "/targets.csv", controlTargets(options));
  }
  RunFacts facts = factsOf(options);
  facts["algorithm"] = plan.algorithm;
  facts["seed"] = std::to_string(plan.seed);
  facts["evaluations"] = std::to_string(counters.evaluations);
  facts["simulations"] = std::to_string(simulator.counts().simulations);
  facts["wall_s"] = exactText(watch.seconds());
  facts["engine"] = toString(engine.engine);
  facts["robot_id"] = robot.digest;
  facts["machine"] = machine;
  facts["version"] = PACKAGE_VERSION;
  writeRunFacts(folder + "/run.csv", facts);
  RunResult result{watch.seconds(), {}};
  for (const auto& [name, entries] : method.repertoires()) {
    result.repertoires[name] = measure(learnedEndings(entries));
  }
  return result;
}

}  // namespace hexapod
