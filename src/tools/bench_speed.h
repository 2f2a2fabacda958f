#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/bench_cases.h"

namespace hexapod {

/// One way to simulate, on one core.
struct EngineSpeed {
  std::string name;
  double cpu_s_per_evaluation = 0.0;  ///< building the behaviour included
  double cpu_s_per_step = 0.0;
};

/// ODE first, then reduced, one robot at a time, then reduced in batches.
struct CaseSpeed {
  std::vector<EngineSpeed> engines;
};

/// Plays random controllers that walk to the end, from the stand, with all engines in turn, a
/// fraction of a second each, for `cpu_s` of the thread's processor time in all: what else the
/// machine does meets all alike.
CaseSpeed measureSpeed(const BenchCase& bench_case, double cpu_s, std::uint64_t seed);

/// Rows of the table of speeds, whose heading is kSpeedHeading.
std::string describe(const std::string& name, const CaseSpeed& speed);
extern const char* const kSpeedHeading;

/// An engine in a BehaviorEvaluator with one thread and with two, in turn.
struct ThreadsSpeed {
  std::string name;
  double cpu_s_per_evaluation[2] = {0.0, 0.0};   ///< of one and of two threads
  double wall_s_per_evaluation[2] = {0.0, 0.0};  ///< the same on the clock
};

/// Both engines; `cpu_s` as above, for each.
std::vector<ThreadsSpeed> measureThreads(const BenchCase& bench_case, double cpu_s,
                                         std::uint64_t seed);

/// Rows of the table of threads, whose heading is kThreadsHeading.
std::string describe(const std::vector<ThreadsSpeed>& speeds);
extern const char* const kThreadsHeading;

}  // namespace hexapod
