// Times the parts that a learning run and a walk are made of, one by one (Google Benchmark).
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>

#include "evolution/nsga2.h"
#include "gait/behavior.h"
#include "geometry/arc.h"
#include "planning/planner.h"
#include "repertoire/archive.h"
#include "repertoire/metrics.h"
#include "robot/load_robot.h"
#include "simulation/reduced/batch_rollout.h"
#include "tools/bench_cases.h"
#include "tools/package_files.h"

namespace hexapod {
namespace {

constexpr double kCommandPeriod_s = 0.030;

const RobotDescription& shippedRobot() {
  static const RobotDescription kRobot =
      loadRobot(packageFolder() + "/urdf/hexapod.urdf", packageFolder() + "/config/hexapod.yaml");
  return kRobot;
}

std::vector<Genome> genomes(std::size_t count) {
  return randomGenomes(count, shippedRobot().geneCount(), 1);
}

Repertoire spreadRepertoire(std::size_t size) {
  Repertoire repertoire;
  repertoire.entries = spreadArchive(size, shippedRobot().geneCount());
  for (Entry& entry : repertoire.entries) {
    const Pose2& end = entry.end_pose;
    const double heading_rad = arcThrough(end.x_m, end.y_m).heading_rad;
    entry.execution = Execution{{end.x_m, end.y_m, heading_rad}, 0.005, 0.01, 8, 0};
  }
  return repertoire;
}

/// A step of 15 ms of a robot that walks.
void step(benchmark::State& state, Engine engine) {
  const std::unique_ptr<World> world = makeWorld(engine, shippedRobot(), Physics());
  const Behavior behavior(shippedRobot(), genomes(1).front(), BehaviorOptions());
  world->restart();
  std::size_t command = 0;
  for (auto _ : state) {
    world->setTargets(behavior.command(command / 2 % behavior.commandCount()));
    benchmark::DoNotOptimize(world->step());
    ++command;
  }
}
BENCHMARK_CAPTURE(step, ode, Engine::kOde);
BENCHMARK_CAPTURE(step, reduced, Engine::kReduced);

/// Whole behaviours in batches, a time per behaviour.
void batchedBehavior(benchmark::State& state) {
  const auto instructions = static_cast<reduced::InstructionSet>(state.range(0));
  BatchRollout batch(shippedRobot(), Physics(), instructions);
  std::vector<Behavior> behaviors;
  for (const Genome& genome : genomes(128)) {
    behaviors.emplace_back(shippedRobot(), genome, BehaviorOptions());
  }
  std::vector<BatchRun> runs;
  for (const Behavior& behavior : behaviors) runs.push_back({&behavior, nullptr});
  for (auto _ : state) benchmark::DoNotOptimize(batch.play(runs, kCommandPeriod_s));
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * runs.size()));
  state.SetLabel(reduced::toString(instructions));
}
BENCHMARK(batchedBehavior)->Unit(benchmark::kMillisecond)->Apply([](auto* each) {
  for (const auto instructions : reduced::availableInstructionSets()) {
    each->Arg(static_cast<std::int64_t>(instructions));
  }
});

/// The commands of a behaviour.
void makeBehavior(benchmark::State& state) {
  const Genome genome = genomes(1).front();
  for (auto _ : state) {
    benchmark::DoNotOptimize(Behavior(shippedRobot(), genome, BehaviorOptions()));
  }
}
BENCHMARK(makeBehavior);

/// The 15 nearest of so many entries.
void nearestEntries(benchmark::State& state) {
  const Archive archive(
      spreadArchive(static_cast<std::size_t>(state.range(0)), shippedRobot().geneCount()));
  Random random(1);
  for (auto _ : state) {
    const double x_m = random.uniform(-0.6, 0.6);
    benchmark::DoNotOptimize(archive.nearest({x_m, random.uniform(-0.6, 0.6), 0.0}, 15));
  }
}
BENCHMARK(nearestEntries)->Arg(500)->Arg(5000)->Arg(50000);

/// Non-dominated sorting of parents and children.
void sortFronts(benchmark::State& state) {
  Random random(1);
  std::vector<Objectives> objectives;
  for (int i = 0; i < 200; ++i) {
    objectives.push_back({random.uniform(), static_cast<double>(random.below(16)), 0.0});
  }
  for (auto _ : state) benchmark::DoNotOptimize(nonDominatedFronts(objectives));
}
BENCHMARK(sortFronts);

/// Genotypic diversity in a front of so many.
void genotypicDiversity(benchmark::State& state) {
  const std::vector<Genome> all = genomes(static_cast<std::size_t>(state.range(0)));
  Front front;
  for (std::size_t i = 0; i < all.size(); ++i) front.push_back(i);
  for (auto _ : state) benchmark::DoNotOptimize(genotypicDiversities(all, front));
}
BENCHMARK(genotypicDiversity)->Arg(10)->Arg(100);

/// The paper's metrics of so many entries.
void metrics(benchmark::State& state) {
  const std::vector<Ending> endings = learnedEndings(
      spreadArchive(static_cast<std::size_t>(state.range(0)), shippedRobot().geneCount()));
  for (auto _ : state) benchmark::DoNotOptimize(measure(endings));
}
BENCHMARK(metrics)->Arg(500)->Arg(5000)->Unit(benchmark::kMillisecond);

/// A plan to a goal so many decimetres away, from 800 entries.
void plan(benchmark::State& state) {
  static const Planner kPlanner(spreadRepertoire(800), PlannerOptions());
  Random random(1);
  PlanRequest request;
  for (auto _ : state) {
    const double direction_rad = random.uniform(-M_PI, M_PI);
    const double distance_m = 0.1 * static_cast<double>(state.range(0));
    request.world_from_goal = {distance_m * std::cos(direction_rad),
                               distance_m * std::sin(direction_rad), random.uniform(-M_PI, M_PI)};
    benchmark::DoNotOptimize(kPlanner.plan(request));
  }
}
BENCHMARK(plan)->Arg(5)->Arg(15)->Arg(50)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hexapod

BENCHMARK_MAIN();
