#include "tools/machine.h"

#include <time.h>

#include <fstream>
#include <thread>

namespace hexapod {
namespace {

double seconds(clockid_t clock) {
  timespec time = {};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

std::string firstValueIn(const std::string& file, const std::string& key) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind(key, 0) != 0) continue;
    const std::size_t begin = line.find_first_not_of(" \t:=\"", key.size());
    const std::size_t end = line.find_last_not_of(" \t\"");
    if (begin != std::string::npos) return line.substr(begin, end - begin + 1);
  }
  return "unknown";
}

std::string machineName() {
  return firstValueIn("/proc/cpuinfo", "model name") + ", " +
         std::to_string(std::thread::hardware_concurrency()) + " cores";
}

double threadCpu_s() { return seconds(CLOCK_THREAD_CPUTIME_ID); }

double processCpu_s() { return seconds(CLOCK_PROCESS_CPUTIME_ID); }

double wall_s() { return seconds(CLOCK_MONOTONIC); }

}  // namespace hexapod
