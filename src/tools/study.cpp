// Repeats the paper's study: runs of several algorithms, each in a process of its own.
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <thread>

#include "common/text.h"
#include "geometry/pose2.h"
#include "robot/load_robot.h"
#include "study/run_files.h"
#include "study/study_folder.h"
#include "study/study_run.h"
#include "tools/machine.h"
#include "tools/own_processes.h"
#include "tools/study_command.h"

namespace hexapod {
namespace {

constexpr int kTakenByAnother = 3;

/// Processes of an mpirun on this machine, this one included; 1 without.
std::int64_t localRanks() {
  for (const char* name : {"OMPI_COMM_WORLD_LOCAL_SIZE", "MPI_LOCALNRANKS"}) {
    const char* text = std::getenv(name);
    if (text != nullptr) return std::max<std::int64_t>(1, integerFromText(text).value_or(1));
  }
  return 1;
}

std::size_t jobsFor(const StudyCommand& command) {
  if (command.jobs > 0) return static_cast<std::size_t>(command.jobs);
  const auto cores = static_cast<std::int64_t>(std::thread::hardware_concurrency());
  return static_cast<std::size_t>(std::max<std::int64_t>(1, cores / localRanks()));
}

void print(const RunPlan& plan, const RunResult& result) {
  std::string text = plan.name() + ": " + std::to_string(std::lround(result.wall_s)) + " s";
  for (const auto& [name, metrics] : result.repertoires) {
    char figures[160];
    std::snprintf(figures, sizeof figures, "; %s %zu entries, %.2f cm, %.2f deg", name.c_str(),
                  metrics.endings, 100.0 * metrics.sparseness_m,
                  metrics.median_error_in_region_rad / kDegree);
    text += figures;
  }
  std::printf("%s\n", text.c_str());
}

/// In a process of its own.
int perform(const StudyCommand& command, const RobotDescription& robot, StudyFolder& folder,
            const RunPlan& plan) {
  try {
    const auto claim = folder.perform(plan, [&](const std::string& run_folder) {
      print(plan, performRun(robot, command.study, plan, machineName(), run_folder));
    });
    return claim == StudyFolder::Claim::kPerformed ? 0 : kTakenByAnother;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s failed: %s\n", plan.name().c_str(), error.what());
    return 1;
  }
}

/// Written aside and renamed: others may do the same at the same time.
void writeTheory(const StudyCommand& command, const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "k_means.csv";
  if (std::filesystem::exists(file)) return;
  const std::filesystem::path aside = folder / (".k_means_" + std::to_string(::getpid()));
  writeTheoreticalSparseness(aside.string(), command.study);
  std::filesystem::rename(aside, file);
}

/// Tells how far a study is, after each of its runs.
class Countdown {
 public:
  explicit Countdown(std::size_t runs) : runs_(runs) {}

  void runEnded() {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    ++ended_;
    const double left_s =
        passed.count() / static_cast<double>(ended_) * static_cast<double>(runs_ - ended_);
    std::printf("  %zu of %zu done, about %.0f min left\n", ended_, runs_, left_s / 60.0);
    std::fflush(stdout);
  }

 private:
  std::size_t runs_;
  std::size_t ended_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The number of runs that failed.
std::size_t study(const StudyCommand& command) {
  const RobotDescription robot = loadRobot(command.urdf, command.robot_config);
  StudyFolder folder(command.folder);
  RunFacts facts = factsOf(command.study);
  facts["robot_id"] = robot.digest;
  folder.requireSameOptions(facts);
  std::vector<RunPlan> left;
  const std::vector<RunPlan> plans = plansOf(command);
  for (const RunPlan& plan : plans) {
    if (!folder.isDone(plan)) left.push_back(plan);
  }
  const std::size_t jobs = jobsFor(command);
  std::printf("Study in %s: %zu of %zu runs are finished; %zu at a time do the others.\n",
              command.folder.c_str(), plans.size() - left.size(), plans.size(), jobs);
  writeTheory(command, folder.path());
  std::size_t failed = 0;
  Countdown countdown(left.size());
  forEachInOwnProcess(
      left.size(), jobs, [&](std::size_t i) { return perform(command, robot, folder, left[i]); },
      [&](std::size_t i, const ProcessEnd& end) {
        if (end.signal != 0) {
          const std::string reason = "ended by signal " + std::to_string(end.signal);
          folder.noteFailure(left[i], "The run was " + reason + ".");
          std::fprintf(stderr, "%s failed: %s\n", left[i].name().c_str(), reason.c_str());
        }
        if (end.signal != 0 || end.exit_code == 1) ++failed;
        countdown.runEnded();
      });
  return failed;
}

}  // namespace
}  // namespace hexapod

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  try {
    const hexapod::StudyCommand command = hexapod::studyCommandFrom({argv + 1, argv + argc});
    if (command.help) {
      std::cout << hexapod::studyHelp();
      return 0;
    }
    const std::size_t failed = hexapod::study(command);
    if (failed == 0) return 0;
    std::cerr << failed << (failed == 1 ? " run" : " runs")
              << " failed; why, say the files *.failed in " << command.folder
              << ". The same command does them again.\n";
    return 1;
  } catch (const std::invalid_argument& error) {
    std::cerr << error.what() << "\nstudy --help lists the options.\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
