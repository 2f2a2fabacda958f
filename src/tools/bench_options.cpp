#include "tools/bench_options.h"

#include "common/options_help.h"
#include "tools/command_line.h"

namespace hexapod {

std::vector<Option> declareOptions(BenchOptions& options) {
  return {option("help", options.help, "Print this text."),
          option("agreement", options.agreement,
                 "Instead of speed, compare where both engines end: this many controllers with the "
                 "shipped robot at 15 ms, a tenth of it in each other case.",
                 0, 1000000),
          option("learning", options.learning,
                 "Instead of that, evolve so many candidates by either preset with one thread and "
                 "with two.",
                 0, 1000000000),
          option("seed", options.seed, "Seed of the controllers.", 0, 1000000000),
          option("threads", options.threads, "Threads that compare; 0: all cores.", 0, 1024),
          option("seconds_per_case", options.seconds_per_case, "s",
                 "Processor time for the speed of each robot and step.", 0.1, 3600.0)};
}

BenchOptions benchOptionsFrom(const std::vector<std::string>& arguments) {
  BenchOptions options;
  applyOptions(declareOptions(options), valuesFromCommandLine(arguments, declareOptions(options)),
               kCommandLine);
  return options;
}

std::string benchHelp() {
  BenchOptions options;
  return helpOn(
      "usage: bench [--name value ...]\n"
      "\n"
      "Measures the engines of the simulation against ODE, in one run: speed on one and two "
      "threads, evolution's own share, memory; or with --agreement where they end, with --learning "
      "how learning runs keep threads and registers busy. About a minute on an idle machine; the "
      "ratios hold on a busy one as well.\n"
      "\n"
      "  bench\n"
      "  bench --agreement 10000\n"
      "  bench --learning 50000\n",
      declareOptions(options));
}

}  // namespace hexapod
