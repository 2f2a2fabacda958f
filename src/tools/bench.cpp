// Measures the engines of the simulation against each other.
#include <exception>
#include <iostream>
#include <stdexcept>

#include "common/text.h"
#include "robot/load_robot.h"
#include "tools/bench_agreement.h"
#include "tools/bench_cases.h"
#include "tools/bench_evolution.h"
#include "tools/bench_learning.h"
#include "tools/bench_machine.h"
#include "tools/bench_options.h"
#include "tools/bench_speed.h"
#include "tools/learner_file.h"
#include "tools/package_files.h"

namespace hexapod {
namespace {

void measureAgreement(const std::vector<BenchCase>& cases, const BenchOptions& options) {
  const int threads = static_cast<int>(options.threads);
  std::cout << kAgreementHeading << std::flush;
  std::vector<std::string> verdicts;
  for (const BenchCase& one : cases) {
    const std::int64_t count = &one == &cases[0] ? options.agreement : (options.agreement + 9) / 10;
    const std::vector<Genome> genomes = mixedControllers(
        one, static_cast<std::size_t>(count), static_cast<std::uint64_t>(options.seed), threads);
    const Agreement agreement = compareEngines(one, genomes, threads, [&](const Agreement& so_far) {
      std::cerr << "so far " << describe(one.name, so_far) << std::flush;
    });
    std::cout << describe(one.name, agreement) << std::flush;
    for (const std::string& line : agreement.verdicts) verdicts.push_back(one.name + ": " + line);
  }
  for (const std::string& line : verdicts) std::cout << line << "\n";
}

void measureSpeed(const std::vector<BenchCase>& cases, const BenchOptions& options) {
  std::cout << kSpeedHeading << std::flush;
  double batched_s = 0.0;  // per evaluation, in the first case
  for (const BenchCase& one : cases) {
    const CaseSpeed speed =
        measureSpeed(one, options.seconds_per_case, static_cast<std::uint64_t>(options.seed));
    if (&one == &cases[0]) batched_s = speed.engines.back().cpu_s_per_evaluation;
    std::cout << describe(one.name, speed) << std::flush;
  }
  std::cout << "\n" << kThreadsHeading << std::flush;
  std::cout << describe(measureThreads(cases[0], options.seconds_per_case,
                                       static_cast<std::uint64_t>(options.seed)))
            << std::flush;
  std::cout << "\n" << kEvolutionHeading << std::flush;
  for (const std::size_t archive : {500, 5000, 50000}) {
    std::cout << describe(measureGeneration(archive, cases[0].robot.geneCount()), batched_s)
              << std::flush;
  }
  std::cout << "\nPeak memory of the whole run: " << peakMemory_mb() << " MB.\n";
}

void measureLearning(const RobotDescription& robot, const BenchOptions& options) {
  std::cout << kLearningHeading << std::flush;
  for (const std::string preset : {"learn", "learn_paper"}) {
    const std::string file = packageFolder() + "/config/" + preset + ".yaml";
    LearnOptions learn;
    applyOptions(declareOptions(learn), valuesFromLearnerFile(file), file);
    learn.evaluations = options.learning;
    learn.seed = options.seed;
    std::cout << describe(preset + ".yaml", measureLearning(robot, learn)) << std::flush;
  }
  std::cout << "\nTwo threads that never wait have "
            << fixedText(cpuOfTwoThreads(options.seconds_per_case), 2)
            << " times the processor time that passes.\n";
}

int bench(const std::vector<std::string>& arguments) {
  const BenchOptions options = benchOptionsFrom(arguments);
  if (options.help) {
    std::cout << benchHelp();
    return 0;
  }
  const std::string folder = packageFolder();
  const std::vector<BenchCase> cases =
      benchCases(loadRobot(folder + "/urdf/hexapod.urdf", folder + "/config/hexapod.yaml"));
  std::cout << describeMachine() << "\n";
  if (options.learning > 0) {
    measureLearning(cases[0].robot, options);
  } else if (options.agreement > 0) {
    measureAgreement(cases, options);
  } else {
    measureSpeed(cases, options);
  }
  return 0;
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  try {
    return hexapod::bench({argv + 1, argv + argc});
  } catch (const std::invalid_argument& error) {
    std::cerr << error.what() << "\nbench --help lists the options.\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
