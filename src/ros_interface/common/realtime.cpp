#include "ros_interface/common/realtime.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace hexapod {
namespace {

int setFifo(int priority) {
  sched_param parameters{};
  parameters.sched_priority = priority;
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
}

// Who may raise the limit raises it: the soft one up to the hard one, a privileged process both.
bool mayLockWithoutLimit() {
  const rlimit unlimited{RLIM_INFINITY, RLIM_INFINITY};
  if (setrlimit(RLIMIT_MEMLOCK, &unlimited) == 0) return true;
  rlimit limit{};
  return getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY;
}

}  // namespace

int askForRealtimePriority(int priority) {
  const int refusal = setFifo(priority);
  if (refusal == 0) return 0;
  rlimit limit{};
  if (getrlimit(RLIMIT_RTPRIO, &limit) != 0 || limit.rlim_cur < 1) return refusal;
  return setFifo(std::min(priority, static_cast<int>(limit.rlim_cur)));
}

std::string lockMemory() {
  if (!mayLockWithoutLimit()) {
    return "The memory cannot be locked without limit (RLIMIT_MEMLOCK), so page faults may make "
           "commands late.";
  }
  if (mlockall(MCL_CURRENT | MCL_FUTURE) == 0) return "";
  return std::string("The memory cannot be locked (") + std::strerror(errno) +
         "), so page faults may make commands late.";
}

}  // namespace hexapod
