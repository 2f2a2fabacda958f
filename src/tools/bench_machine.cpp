#include "tools/bench_machine.h"

#include <sys/resource.h>
#include <time.h>

#include <fstream>
#include <thread>

#include "simulation/batch_stepper.h"

namespace hexapod {
namespace {

double seconds(clockid_t clock) {
  timespec time = {};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// What follows the key and its separators in the first line that starts with it.
std::string valueIn(const std::string& file, const std::string& key) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind(key, 0) != 0) continue;
    const std::size_t begin = line.find_first_not_of(" \t:=\"", key.size());
    const std::size_t end = line.find_last_not_of(" \t\"");
    if (begin != std::string::npos) return line.substr(begin, end - begin + 1);
  }
  return "unknown";
}

std::string instructionSets() {
  std::string names;
  for (const reduced::InstructionSet instructions : reduced::availableInstructionSets()) {
    names += (names.empty() ? "" : ", ") + toString(instructions);
  }
  return names + "; batches of " + std::to_string(reduced::lanes(reduced::bestInstructionSet()));
}

}  // namespace

std::string describeMachine() {
  return "processor: " + valueIn("/proc/cpuinfo", "model name") + ", " +
         std::to_string(std::thread::hardware_concurrency()) +
         " cores\nload (1, 5, 15 minutes): " + valueIn("/proc/loadavg", "") +
         "\nsystem: " + valueIn("/etc/os-release", "PRETTY_NAME") + "\ncompiler: " +
#ifdef __clang__
         "clang " __clang_version__
#else
         "g++ " __VERSION__
#endif
         "\nflags: " BENCH_FLAGS "\ninstruction sets: " +
         instructionSets() + "\n";
}

double threadCpu_s() { return seconds(CLOCK_THREAD_CPUTIME_ID); }

double processCpu_s() { return seconds(CLOCK_PROCESS_CPUTIME_ID); }

double wall_s() { return seconds(CLOCK_MONOTONIC); }

double peakMemory_mb() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

}  // namespace hexapod
