#pragma once

#include <string>

namespace hexapod {

/// What follows the key and its separators in the first line of a file that starts with it, or
/// "unknown".
std::string firstValueIn(const std::string& file, const std::string& key);

/// Processor and number of cores: "AMD EPYC, 2 cores".
std::string machineName();

}  // namespace hexapod
