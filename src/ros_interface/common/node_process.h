#pragma once

#include <atomic>
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
/// SIGINT, SIGTERM and SIGHUP only set leaveFlag(), and break off no system call: a body ends in
/// order. Unless it has work to save the process is gone within 2 s, whatever hangs: a master, also
/// in the midst of its start, or a callback.
int runNode(int argc, char** argv, const NodeMain& node);

/// True once a signal asked the process to leave.
const std::atomic<bool>& leaveFlag();

/// True once the process was asked to leave, by a signal or by ROS (rosnode kill).
bool askedToLeave();

/// Returns when askedToLeave().
void waitUntilAskedToLeave();

/// Leaves a sentence for whoever launched this node, to be told when it has ended: what was
/// achieved, where it is, what to do next. It is the private parameter last_words.
void leaveLastWords(const std::string& sentence);

/// From now on the node has work to save when asked to leave, however long that takes.
void saveBeforeLeaving();

/// Returns `code`, and ends the process with it within 2 s, counted from the signal where one came
/// and nothing was to be saved, if it has not ended by itself. For a body whose work is done.
int leaveInTime(int code);

}  // namespace hexapod
