#include "ros_interface/common/realtime.h"

#include <pthread.h>
#include <ros/poll_manager.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace hexapod {
namespace {

int setRoundRobin(int priority) {
  sched_param parameters{};
  parameters.sched_priority = priority;
  return pthread_setschedparam(pthread_self(), SCHED_RR, &parameters);
}

// True when RLIMIT_MEMLOCK allows all there will ever be; who may raise it has it raised.
bool lockIsUnlimited() {
  const rlimit unlimited{RLIM_INFINITY, RLIM_INFINITY};
  if (setrlimit(RLIMIT_MEMLOCK, &unlimited) == 0) return true;
  rlimit limit{};
  return getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY;
}

// More is locked than RLIMIT_MEMLOCK allows: the process has the privilege not to be limited.
bool lockedBeyondLimit() {
  rlimit limit{};
  long pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return getrlimit(RLIMIT_MEMLOCK, &limit) == 0 &&
         static_cast<rlim_t>(pages * sysconf(_SC_PAGESIZE)) > limit.rlim_cur;
}

}  // namespace

int askForRealtimePriority(int priority) {
  const int refusal = setRoundRobin(priority);
  if (refusal == 0) return 0;
  rlimit limit{};
  if (getrlimit(RLIMIT_RTPRIO, &limit) != 0 || limit.rlim_cur < 1) return refusal;
  return setRoundRobin(std::min(priority, static_cast<int>(limit.rlim_cur)));
}

// Linux keeps it per thread.
void beLessUrgent(int niceness) { setpriority(PRIO_PROCESS, 0, niceness); }

// roscpp calls the listener in the thread that writes the sockets, at least every 100 ms.
void raiseTransportPriority() {
  ros::PollManager::instance()->addPollThreadListener([] {
    thread_local bool asked = false;
    if (!asked) askForRealtimePriority(RealtimePriority::kTransport);
    asked = true;
  });
}

std::string lockMemory() {
  const bool unlimited = lockIsUnlimited();
  if (mlockall(MCL_CURRENT | MCL_FUTURE) == 0) {
    if (unlimited || lockedBeyondLimit()) return "";
    munlockall();  // or later allocations fail at the limit
    errno = EPERM;
  }
  return std::string("The memory cannot be locked (") + std::strerror(errno) +
         "), so page faults may make commands late. Allow it (memlock unlimited in "
         "/etc/security/limits.conf), or set ~realtime to false.";
}

}  // namespace hexapod
