#pragma once

#include <cstddef>
#include <functional>

namespace hexapod {

/// How a process ended: by returning a code, or by a signal.
struct ProcessEnd {
  int exit_code = 0;
  int signal = 0;  ///< 0: none
};

/// Calls work(i) for every i < count in a process of its own, at most `jobs` (>= 1) at a time, in
/// order; what it returns (0 .. 255) is the process' exit code. `ended` is told of each end, in
/// this process. Whatever happens to one does not stop the others; they end with this process.
///
/// To be called by a process that has no other threads. Throws std::runtime_error when no process
/// can be started.
void forEachInOwnProcess(std::size_t count, std::size_t jobs,
                         const std::function<int(std::size_t)>& work,
                         const std::function<void(std::size_t, const ProcessEnd&)>& ended);

}  // namespace hexapod
