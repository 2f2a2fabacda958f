#pragma once

#include <string>

namespace hexapod {

/// Real-time priorities of the threads that a command and its answer pass through: above the
/// kernel's ordinary threads, below its interrupt threads (50).
struct RealtimePriority {
  static constexpr int kLoop = 40;       ///< decides what is sent
  static constexpr int kSending = 39;    ///< serialises it
  static constexpr int kFeedback = 38;   ///< judges what the robot answers
  static constexpr int kRobot = 37;      ///< a simulated robot, which obeys
  static constexpr int kTransport = 36;  ///< reads and writes sockets; last: others decide how much
};

/// Asks for SCHED_RR (equal ones take turns) at `priority`, or as near to it as RLIMIT_RTPRIO
/// allows, for the calling thread. Returns 0, or the errno of the refusal; the thread then goes on
/// as it was.
int askForRealtimePriority(int priority);

/// How much less urgent than others a thread is that computes for long (setpriority): what has to
/// be answered at once is not kept waiting on a machine with few cores.
struct Niceness {
  static constexpr int kThinking = 5;     ///< somebody waits for what comes out
  static constexpr int kBackground = 19;  ///< nobody does
};

/// For the calling thread alone; what it starts from then on inherits it.
void beLessUrgent(int niceness);

/// Asks for RealtimePriority::kTransport for roscpp's own thread, which reads and writes the
/// sockets.
void raiseTransportPriority();

/// Keeps all pages of the process in memory, now and later: a page fault makes a command late.
/// Returns "", or a sentence why the system does not allow it. Without the right to lock without
/// limit nothing is locked, since later allocations would then fail.
std::string lockMemory();

}  // namespace hexapod
