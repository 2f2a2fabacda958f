#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "learning/learn_options.h"
#include "simulation/reduced/batch_rollout.h"

namespace hexapod {

/// What learning runs of one and of two threads took for the same candidates.
struct LearningSpeed {
  int threads = 1;
  std::int64_t evaluations = 0;
  std::int64_t simulations = 0;
  double cpu_s = 0.0;  ///< of all threads
  double wall_s = 0.0;
  LaneUse use;
};

/// Evolution of `options.evaluations` candidates with one thread and with two, in turn, generation
/// by generation: what else the machine does meets both alike. No checks.
std::vector<LearningSpeed> measureLearning(const RobotDescription& robot,
                                           const LearnOptions& options);

/// Processor time per time of two threads that never wait for anything, over so many seconds: the
/// most that a run of two threads can have beside whatever else the machine does.
double cpuOfTwoThreads(double seconds);

/// Rows of the table of learning, whose heading is kLearningHeading; the one with one thread first.
std::string describe(const std::string& preset, const std::vector<LearningSpeed>& speeds);
extern const char* const kLearningHeading;

}  // namespace hexapod
