#include "tools/bench_plan_options.h"

#include <stdexcept>

#include "common/options_help.h"
#include "tools/command_line.h"

namespace hexapod {

std::vector<Option> declareOptions(BenchPlanOptions& options) {
  return {
      option("help", options.help, "Print this text."),
      option("repertoire", options.repertoire,
             "Repertoire file to plan with, of the shipped robot: evolve writes one."),
      option("csv", options.csv,
             "Another repertoire, columns dx, dy, dyaw, planned with in the empty world as well."),
      option("seed", options.seed, "Seed of worlds, starts and goals.", 0, 1000000000),
      option("goals", options.goals, "Goals in the empty world.", 1, 1000000),
      option("world_goals", options.world_goals, "Goals in each kind of world.", 1, 100000),
      option("routes", options.routes, "Routes through six waypoints in each kind of world.", 0,
             100000),
      option("walks", options.walks, "Walks of the simulated robot in those worlds, spread evenly.",
             0, 100000),
      option("write", options.write, "Also write the report to this file.")};
}

BenchPlanOptions benchPlanOptionsFrom(const std::vector<std::string>& arguments) {
  BenchPlanOptions options;
  applyOptions(declareOptions(options), valuesFromCommandLine(arguments, declareOptions(options)),
               kCommandLine);
  if (!options.help && options.repertoire.empty()) {
    throw std::invalid_argument(
        "bench_plan needs --repertoire FILE.db; evolve --file FILE.db --evaluations 50000 --seed 1 "
        "writes one.");
  }
  return options;
}

std::string benchPlanHelp() {
  BenchPlanOptions options;
  return helpOn(
      "usage: bench_plan --repertoire FILE.db [--name value ...]\n"
      "\n"
      "Measures the planner on one core: plans in the empty world and among obstacles, with what "
      "is proved of them, and checks that nothing is touched; with --walks the simulated robot "
      "walks them as well. Times are those of the processor.\n"
      "\n"
      "  bench_plan --repertoire a.db\n"
      "  bench_plan --repertoire a.db --walks 200 --write results/planning.md\n",
      declareOptions(options));
}

}  // namespace hexapod
