#pragma once

#include <string>

namespace hexapod {

/// Processor, cores, load, operating system, compiler, flags and instruction set of the batches, a
/// line each.
std::string describeMachine();

/// Processor time of the calling thread [s].
double threadCpu_s();

/// Processor time of all threads of the process [s].
double processCpu_s();

/// Time on a clock that never goes back [s].
double wall_s();

/// Largest resident memory of the process so far [MB].
double peakMemory_mb();

}  // namespace hexapod
