#include "tools/bench_speed.h"

#include <deque>
#include <functional>
#include <memory>

#include "common/text.h"
#include "evaluation/behavior_evaluator.h"
#include "gait/behavior.h"
#include "simulation/reduced/batch_rollout.h"
#include "simulation/rollout.h"
#include "tools/machine.h"

namespace hexapod {

const char* const kSpeedHeading =
    "| robot, step | engine | evaluations/s/core | times ODE | us per step |\n"
    "|---|---|---|---|---|\n";
const char* const kThreadsHeading =
    "| engine | evaluations/s/core, 1 thread | 2 threads | evaluations/s by the clock, 1 thread | "
    "2 threads | times 1 thread |\n"
    "|---|---|---|---|---|---|\n";

namespace {

constexpr std::size_t kCandidates = 512;

/// Some controllers that do not fall: all of their behaviours have the same number of steps.
std::vector<Genome> walkers(const BenchCase& bench_case, std::uint64_t seed) {
  const std::vector<Genome> genomes =
      randomGenomes(kCandidates, bench_case.robot.geneCount(), seed);
  BehaviorEvaluator evaluator(
      std::make_shared<WorldPool>(Engine::kReduced, bench_case.robot, bench_case.physics, 1),
      BehaviorOptions());
  const std::vector<Outcome> outcomes = evaluator.evaluate(genomes);
  std::vector<Genome> walking;
  for (std::size_t i = 0; i < genomes.size(); ++i) {
    if (outcomes[i].walked()) walking.push_back(genomes[i]);
  }
  return walking;
}

/// One way to play a slice of behaviours, with the time it has taken so far.
struct Contender {
  EngineSpeed speed;
  std::size_t slice = 1;  // behaviours at a time
  std::function<void(const std::vector<BatchRun>&)> play;
  double cpu_s = 0.0;
  std::size_t played = 0;
};

void playSlice(Contender& contender, const BenchCase& bench_case,
               const std::vector<Genome>& genomes) {
  const BehaviorOptions options;
  const double begin_s = threadCpu_s();
  std::deque<Behavior> behaviors;
  std::vector<BatchRun> runs;
  for (std::size_t i = 0; i < contender.slice; ++i) {
    const Genome& genome = genomes[(contender.played + i) % genomes.size()];
    behaviors.emplace_back(bench_case.robot, genome, options);
    runs.push_back({&behaviors.back(), nullptr});
  }
  contender.play(runs);
  contender.cpu_s += threadCpu_s() - begin_s;
  contender.played += contender.slice;
}

std::function<void(const std::vector<BatchRun>&)> oneByOne(Engine engine,
                                                           const BenchCase& bench_case) {
  const std::shared_ptr<World> world = makeWorld(engine, bench_case.robot, bench_case.physics);
  return [world](const std::vector<BatchRun>& runs) {
    for (const BatchRun& run : runs) {
      world->restart();
      play(*world, *run.behavior, BehaviorOptions().command_period_s);
    }
  };
}

std::function<void(const std::vector<BatchRun>&)> inBatches(const BenchCase& bench_case) {
  const auto batch = std::make_shared<BatchRollout>(bench_case.robot, bench_case.physics);
  return [batch](const std::vector<BatchRun>& runs) {
    batch->play(runs, BehaviorOptions().command_period_s);
  };
}

/// The evaluator of one engine with so many threads, with the time it has taken so far.
struct Team {
  std::unique_ptr<BehaviorEvaluator> evaluator;
  double cpu_s = 0.0;
  double wall_s = 0.0;
  std::size_t played = 0;
};

void playSlice(Team& team, const std::vector<Genome>& genomes) {
  const double begin_cpu_s = processCpu_s(), begin_wall_s = wall_s();
  team.evaluator->evaluate(genomes);
  team.cpu_s += processCpu_s() - begin_cpu_s;
  team.wall_s += wall_s() - begin_wall_s;
  team.played += genomes.size();
}

ThreadsSpeed measureThreads(const BenchCase& bench_case, Engine engine,
                            const std::vector<Genome>& genomes, double cpu_s) {
  std::deque<Team> teams;
  for (const int threads : {1, 2}) {
    teams.emplace_back();
    teams.back().evaluator = std::make_unique<BehaviorEvaluator>(
        std::make_shared<WorldPool>(engine, bench_case.robot, bench_case.physics, threads),
        BehaviorOptions());
    teams.back().evaluator->evaluate(genomes);  // builds the worlds
  }
  while (teams[0].cpu_s + teams[1].cpu_s < cpu_s) {
    for (Team& team : teams) playSlice(team, genomes);
  }
  ThreadsSpeed speed;
  speed.name = engine == Engine::kOde ? "ODE" : "reduced, batched";
  for (std::size_t i = 0; i < 2; ++i) {
    speed.cpu_s_per_evaluation[i] = teams[i].cpu_s / teams[i].played;
    speed.wall_s_per_evaluation[i] = teams[i].wall_s / teams[i].played;
  }
  return speed;
}

}  // namespace

CaseSpeed measureSpeed(const BenchCase& bench_case, double cpu_s, std::uint64_t seed) {
  const std::vector<Genome> genomes = walkers(bench_case, seed);
  std::vector<Contender> contenders(3);
  contenders[0].speed.name = "ODE";
  contenders[0].slice = 4;
  contenders[0].play = oneByOne(Engine::kOde, bench_case);
  contenders[1].speed.name = "reduced, scalar";
  contenders[1].slice = 32;
  contenders[1].play = oneByOne(Engine::kReduced, bench_case);
  contenders[2].speed.name = "reduced, batched";
  contenders[2].slice = 64;
  contenders[2].play = inBatches(bench_case);
  for (double spent_s = 0.0; spent_s < cpu_s;) {
    spent_s = 0.0;
    for (Contender& contender : contenders) {
      playSlice(contender, bench_case, genomes);
      spent_s += contender.cpu_s;
    }
  }
  const BehaviorOptions options;
  const double steps =
      static_cast<double>(behaviorParts(options).total() *
                          stepsPerCommand(options.command_period_s, bench_case.physics.step_s));
  CaseSpeed speed;
  for (Contender& contender : contenders) {
    contender.speed.cpu_s_per_evaluation = contender.cpu_s / contender.played;
    contender.speed.cpu_s_per_step = contender.speed.cpu_s_per_evaluation / steps;
    speed.engines.push_back(contender.speed);
  }
  return speed;
}

std::string describe(const std::string& name, const CaseSpeed& speed) {
  std::string rows;
  const double ode_s = speed.engines.front().cpu_s_per_evaluation;
  for (const EngineSpeed& engine : speed.engines) {
    rows += tableRow({name, engine.name, fixedText(1.0 / engine.cpu_s_per_evaluation, 1),
                      fixedText(ode_s / engine.cpu_s_per_evaluation, 1),
                      fixedText(1e6 * engine.cpu_s_per_step, 2)});
  }
  return rows;
}

std::vector<ThreadsSpeed> measureThreads(const BenchCase& bench_case, double cpu_s,
                                         std::uint64_t seed) {
  const std::vector<Genome> genomes = walkers(bench_case, seed);
  // So many at a time that beginning and end of a batch, when threads wait for others, weigh
  // little.
  const std::vector<Genome> few(genomes.begin(), genomes.begin() + 32);
  std::vector<Genome> many;
  for (int i = 0; i < 8; ++i) many.insert(many.end(), genomes.begin(), genomes.end());
  return {measureThreads(bench_case, Engine::kOde, few, cpu_s),
          measureThreads(bench_case, Engine::kReduced, many, cpu_s)};
}

std::string describe(const std::vector<ThreadsSpeed>& speeds) {
  std::string rows;
  for (const ThreadsSpeed& speed : speeds) {
    std::vector<std::string> cells = {speed.name};
    for (const double s : speed.cpu_s_per_evaluation) cells.push_back(fixedText(1.0 / s, 1));
    for (const double s : speed.wall_s_per_evaluation) cells.push_back(fixedText(1.0 / s, 1));
    cells.push_back(fixedText(speed.wall_s_per_evaluation[0] / speed.wall_s_per_evaluation[1], 2));
    rows += tableRow(cells);
  }
  return rows;
}

}  // namespace hexapod
