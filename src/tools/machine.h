#pragma once

#include <string>

namespace hexapod {

/// What follows the key and its separators in the first line of a file that starts with it, or
/// "unknown".
std::string firstValueIn(const std::string& file, const std::string& key);

/// Processor and number of cores: "AMD EPYC, 2 cores".
std::string machineName();

/// Processor time of the calling thread [s].
double threadCpu_s();

/// Processor time of all threads of the process [s].
double processCpu_s();

/// Time on a clock that never goes back [s].
double wall_s();

}  // namespace hexapod
