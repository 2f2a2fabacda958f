#include "tools/bench_machine.h"

#include <sys/resource.h>

#include "simulation/reduced/batch_stepper.h"
#include "tools/machine.h"

namespace hexapod {
namespace {

std::string instructionSets() {
  std::string names;
  for (const reduced::InstructionSet instructions : reduced::availableInstructionSets()) {
    names += (names.empty() ? "" : ", ") + toString(instructions);
  }
  return names + "; batches of " + std::to_string(reduced::lanes(reduced::bestInstructionSet()));
}

}  // namespace

std::string describeMachine() {
  return "processor: " + machineName() +
         "\nload (1, 5, 15 minutes): " + firstValueIn("/proc/loadavg", "") +
         "\nsystem: " + firstValueIn("/etc/os-release", "PRETTY_NAME") + "\ncompiler: " +
#ifdef __clang__
         "clang " __clang_version__
#else
         "g++ " __VERSION__
#endif
         "\nflags: " BENCH_FLAGS "\ninstruction sets: " +
         instructionSets() + "\n";
}

double peakMemory_mb() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

}  // namespace hexapod
