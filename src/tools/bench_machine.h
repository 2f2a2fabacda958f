#pragma once

#include <string>

namespace hexapod {

/// Processor, cores, load, operating system, compiler, flags and instruction set of the batches, a
/// line each.
std::string describeMachine();

/// Largest resident memory of the process so far [MB].
double peakMemory_mb();

}  // namespace hexapod
