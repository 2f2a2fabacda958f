// Measures the planner: plans, proofs, obstacles, and the simulated robot on its way among them.
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "common/text.h"
#include "geometry/pose2.h"
#include "repertoire/import_repertoire.h"
#include "repertoire/repertoire_file.h"
#include "robot/load_robot.h"
#include "simulation/base_path.h"
#include "simulation/swept_footprint.h"
#include "tools/bench_machine.h"
#include "tools/bench_plan_options.h"
#include "tools/package_files.h"
#include "tools/plan_trial.h"
#include "tools/route_trial.h"
#include "tools/walk_trial.h"

namespace hexapod {
namespace {

constexpr double kTight_m = 0.05;
const GoalTolerance kEmptyTolerance{0.01, 1.0 * kDegree};
const GoalTolerance kCoarseTolerance{0.02, 2.0 * kDegree};
const GoalTolerance kWorldTolerance{0.02, 3.0 * kDegree};
const GoalTolerance kWalkTolerance{0.03, 5.0 * kDegree};

/// Prints, and keeps what was printed.
class Report {
 public:
  void add(const std::string& text) {
    std::cout << text << std::flush;
    text_ += text;
  }
  void writeTo(const std::string& file) const {
    std::ofstream out(file);
    out << text_;
    out.close();
    if (!out) throw std::runtime_error("The report " + file + " cannot be written.");
  }

 private:
  std::string text_;
};

std::vector<PlanTrial> runAll(const PlanTrials& trials, const std::vector<PlanTask>& tasks,
                              std::uint64_t seed) {
  Random random(seed);
  std::vector<PlanTrial> results;
  for (const PlanTask& task : tasks) results.push_back(trials.run(task, random));
  return results;
}

/// How often planning ended how.
std::string describeCodes(const std::vector<PlanTrial>& trials) {
  std::map<std::string, int> counts;
  for (const PlanTrial& trial : trials) ++counts[toString(trial.plan.code)];
  std::string text;
  for (const auto& [code, count] : counts) {
    text += (text.empty() ? "" : ", ") + code + " " + std::to_string(count);
  }
  return text;
}

/// How many of the goals without a plan lie behind passages that leave the footprint with its
/// margin less than kTight_m on either side: less than the base sways beside the arc it walks
/// along.
std::string describeTight(const std::vector<PlanTask>& tasks, const std::vector<PlanTrial>& trials,
                          double radius_m) {
  int failed = 0;
  int tight = 0;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (trials[i].plan.success()) continue;
    ++failed;
    tight += isConnected(tasks[i], radius_m + kTight_m) ? 0 : 1;
  }
  if (failed == 0) return "";
  return "; " + std::to_string(tight) + " of these " + std::to_string(failed) +
         " through a passage with less than " + fixedText(100.0 * kTight_m, 0) +
         " cm to spare on either side";
}

void measureEmpty(const std::string& name, const Repertoire& repertoire,
                  const GoalTolerance& tolerance, const BenchPlanOptions& options, Report& report) {
  const Planner planner(repertoire, PlannerOptions{});
  const Footprint point;
  const PlanTrials trials(repertoire, planner, {}, point);
  const auto seed = static_cast<std::uint64_t>(options.seed);
  const auto tasks = tasksInTheEmpty(static_cast<std::size_t>(options.goals), tolerance, seed);
  report.add(describe(name, runAll(trials, tasks, seed)));
}

void measureWorlds(const Repertoire& repertoire, const EntryPaths& paths,
                   const Footprint& footprint, const BenchPlanOptions& options, Report& report) {
  const Planner planner(repertoire, PlannerOptions{}, paths);
  const ObstacleOptions obstacle_options;
  const PlanTrials trials(repertoire, planner, paths, footprint);
  const auto count = static_cast<std::size_t>(options.world_goals);
  auto seed = static_cast<std::uint64_t>(options.seed);
  std::string failures;
  for (const WorldKind& kind : openWorldKinds()) {
    const auto tasks = tasksIn(kind, count, kWorldTolerance, footprint, obstacle_options, ++seed);
    const std::vector<PlanTrial> results = runAll(trials, tasks, seed);
    report.add(describe(kind.name, results));
    failures +=
        "- " + kind.name + ": " + describeCodes(results) +
        describeTight(tasks, results, footprint.outer_m() + obstacle_options.footprint_margin_m) +
        "\n";
  }
  const WorldKind closed = closedWorldKind();
  const auto tasks = tasksIn(closed, count, kWorldTolerance, footprint, obstacle_options, ++seed);
  failures += "- " + closed.name + ": " + describeCodes(runAll(trials, tasks, seed)) + "\n";
  report.add("\nHow planning ended:\n\n" + failures);
}

/// Through waypoints leg by leg and as a whole, in the empty world and in some of the others.
void measureRoutes(const Repertoire& repertoire, const EntryPaths& paths,
                   const Footprint& footprint, const BenchPlanOptions& options, Report& report) {
  constexpr std::size_t kWaypoints = 6;
  const AdaptivePlanner planner(repertoire, PlannerOptions{}, nullptr, paths);
  const std::size_t goals = kWaypoints * static_cast<std::size_t>(options.routes);
  auto seed = static_cast<std::uint64_t>(options.seed) + 200;
  report.add("\nRoutes through " + std::to_string(kWaypoints) +
             " waypoints, to 5 cm and any heading, the last one to 2 cm and 3 degrees:\n\n" +
             kRouteHeading);
  const auto measure = [&](const std::string& name, const std::vector<PlanTask>& tasks) {
    Random random(seed);
    std::vector<RouteTrial> trials;
    for (const RouteTask& task : routesOf(tasks, kWaypoints)) {
      trials.push_back(runRoute(planner, task, random));
    }
    report.add(describe(name, trials));
  };
  measure("empty", tasksInTheEmpty(goals, kWorldTolerance, seed));
  for (const WorldKind& kind : openWorldKinds()) {
    measure(kind.name, tasksIn(kind, goals, kWorldTolerance, footprint, ObstacleOptions{}, ++seed));
  }
}

/// The simulated robot walks, in ODE, to the goals of those worlds.
void measureWalks(const Repertoire& repertoire, const EntryPaths& paths,
                  const RobotDescription& robot, const BenchPlanOptions& options, Report& report) {
  const std::vector<WorldKind> kinds = openWorldKinds();
  const auto count = static_cast<std::size_t>(options.walks) / kinds.size();
  auto seed = static_cast<std::uint64_t>(options.seed) + 100;
  const Footprint footprint = sweptFootprint(robot);
  report.add("\n" + std::string(kWalkHeading));
  std::string failures;
  for (const WorldKind& kind : kinds) {
    const auto tasks = tasksIn(kind, count, kWalkTolerance, footprint, ObstacleOptions{}, ++seed);
    std::vector<WalkTrial> trials(tasks.size());
    WorldPool worlds(Engine::kOde, robot, Physics{}, 1);
    worlds.forEach(tasks.size(), [&](World& world, std::size_t i) {
      const auto planner = std::make_shared<AdaptivePlanner>(repertoire, PlannerOptions{});
      planner->setPaths(paths);
      trials[i] = walkThrough(world, planner, BehaviorOptions{}, tasks[i]);
    });
    report.add(describe(kind.name, trials));
    for (const WalkTrial& trial : trials) {
      if (trial.end.state == WalkState::kArrived) continue;
      failures += "- " + kind.name + ": " + trial.end.message + "\n";
    }
  }
  if (!failures.empty()) report.add("\nWalks that did not arrive:\n\n" + failures);
}

EntryPaths pathsOf(const Repertoire& repertoire, const RobotDescription& robot) {
  WorldPool worlds(chooseEngine("reduced", robot).engine, robot, Physics{});
  std::vector<Genome> genomes;
  for (const Entry& entry : repertoire.entries) genomes.push_back(entry.genome);
  return basePaths(worlds, BehaviorOptions{}, genomes);
}

std::string introduction(const BenchPlanOptions& options, const Repertoire& repertoire,
                         const Footprint& footprint) {
  return "# Planning, measured\n\n`./run bench plan --seed " + std::to_string(options.seed) +
         " --goals " + std::to_string(options.goals) + " --world_goals " +
         std::to_string(options.world_goals) + " --routes " + std::to_string(options.routes) +
         " --walks " + std::to_string(options.walks) +
         (options.csv.empty() ? "" : " --csv " + options.csv) +
         "`, processor time of one core.\n\n" + describeMachine() + "\nRepertoire: run " +
         repertoire.run_id + ", " + std::to_string(repertoire.entries.size()) +
         " entries. Footprint: a disc of " + fixedText(100.0 * footprint.outer_m(), 1) +
         " cm, and a margin of " + fixedText(100.0 * ObstacleOptions{}.footprint_margin_m, 1) +
         " cm, of " + fixedText(100.0 * ObstacleOptions{}.narrow_margin_m, 1) +
         " cm through passages that are too narrow for it. Worlds of 8 m x 8 m in cells of 5 cm, "
         "ten of each kind; start and goal connected "
         "for "
         "the footprint with its margin; plans to 2 cm and 3 degrees, walks to 3 cm and 5 "
         "degrees.\n\n";
}

int benchPlan(const std::vector<std::string>& arguments) {
  const BenchPlanOptions options = benchPlanOptionsFrom(arguments);
  if (options.help) {
    std::cout << benchPlanHelp();
    return 0;
  }
  const std::string folder = packageFolder();
  const RobotDescription robot =
      loadRobot(folder + "/urdf/hexapod.urdf", folder + "/config/hexapod.yaml");
  const Repertoire repertoire = loadRepertoire(options.repertoire);
  const Footprint footprint = sweptFootprint(robot);
  const EntryPaths paths = pathsOf(repertoire, robot);
  Report report;
  report.add(introduction(options, repertoire, footprint));
  report.add(kPlanHeading);
  measureEmpty("empty, 1 cm, 1 degree", repertoire, kEmptyTolerance, options, report);
  if (!options.csv.empty()) {
    measureEmpty("empty, the other repertoire, 2 cm, 2 degrees", importRepertoire(options.csv, {}),
                 kCoarseTolerance, options, report);
  }
  measureWorlds(repertoire, paths, footprint, options, report);
  if (options.routes > 0) measureRoutes(repertoire, paths, footprint, options, report);
  if (options.walks > 0) measureWalks(repertoire, paths, robot, options, report);
  if (!options.write.empty()) report.writeTo(options.write);
  return 0;
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  try {
    return hexapod::benchPlan({argv + 1, argv + argc});
  } catch (const std::invalid_argument& error) {
    std::cerr << error.what() << "\nbench_plan --help lists the options.\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
