#pragma once

#include <atomic>
#include <chrono>
#include <string>

namespace hexapod {

/// What a node's executable is made of.
struct NodeMain {
  const char* name;          ///< default node name
  int (*body)();             ///< returns the exit code; ROS is started, and there is a master
  std::string (*options)();  ///< its options as a table, for --help
};

/// The main() of every node. With --help prints the options. Otherwise waits for a ROS master
/// (naming it every few seconds), starts ROS, runs the body. What the body throws becomes one FATAL
/// line per sentence and an exit code: 2 for std::invalid_argument (wrong options), else 1.
/// SIGINT, SIGTERM and SIGHUP only set leaveFlag(): a body ends in order.
int runNode(int argc, char** argv, const NodeMain& node);

/// True once a signal asked the process to leave.
const std::atomic<bool>& leaveFlag();

/// True once the process was asked to leave, by a signal or by ROS (rosnode kill).
bool askedToLeave();

/// Returns when askedToLeave().
void waitUntilAskedToLeave();

/// From now on the process ends with `code` after `longest`, steady time, if it has not by then: a
/// master that hangs, or a callback that waits, keeps nobody from leaving.
void leaveWithin(std::chrono::milliseconds longest, int code);

}  // namespace hexapod
